import { effect, signal } from '@preact/signals';
import { settings } from '../model/settings';
import { dark, light, palette } from './palette';

/** Applies the chosen theme, or the system's, to the style sheet and to the painted colours. Call once. */
export function followTheme(): void {
  const query = window.matchMedia('(prefers-color-scheme: dark)');
  const systemIsDark = signal(query.matches);
  query.addEventListener('change', () => {
    systemIsDark.value = query.matches;
  });
  effect(() => {
    const { theme } = settings.value;
    const isDark = theme === 'dark' || (theme === 'system' && systemIsDark.value);
    document.documentElement.dataset['theme'] = isDark ? 'dark' : 'light';
    palette.value = isDark ? dark : light;
  });
}
