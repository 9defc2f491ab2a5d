import { computed, effect, signal } from '@preact/signals';
import type { CoordinateStyle } from '../geo/coordinates';
import { projectionCodes, type ProjectionCode } from '../geo/projections';

/** Settings of the user for the screen, stored in this browser. */
export interface Settings {
  projection: ProjectionCode;
  distance: 'km' | 'nm';
  speed: 'm/s' | 'kn';
  coordinates: CoordinateStyle;
  theme: 'light' | 'dark' | 'system';
  shortcuts: boolean;
  legend?: boolean; // unfolded; until a person has chosen, by the room on the screen
}

const defaults: Settings = {
  projection: 'EPSG:3413', distance: 'km', speed: 'm/s', coordinates: 'dm', theme: 'system', shortcuts: true,
};
const key = 'floeplan.settings';

function stored(): Settings {
  try {
    const read = JSON.parse(localStorage.getItem(key) ?? '{}') as Partial<Settings>;
    const settings = { ...defaults, ...read };
    return projectionCodes.includes(settings.projection) ? settings : { ...settings, projection: defaults.projection };
  } catch {
    return defaults;
  }
}

export const settings = signal<Settings>(stored());

export function change(part: Partial<Settings>): void {
  settings.value = { ...settings.value, ...part };
}

export const projection = computed(() => settings.value.projection);

effect(() => {
  const text = JSON.stringify(settings.value);
  try {
    localStorage.setItem(key, text);
  } catch {
    // Without storage the browser only forgets the choice.
  }
});
