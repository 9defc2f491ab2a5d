import { signal } from '@preact/signals';

/** What is open on the screen apart from the map. */
export const leftTab = signal<'setup' | 'plans' | 'data'>('setup');
export const rightTab = signal<'waypoints' | 'profile' | 'departures' | 'flights'>('waypoints');
export const dialog = signal<'export' | 'compare' | 'help' | 'jobs' | 'login' | undefined>(undefined);
export const drawer = signal<'left' | 'right' | undefined>(undefined);

/** A short text about what was just done. It is shown for a few seconds. */
export const notice = signal('');
const notice_ms = 4000;
let noticeTimer: ReturnType<typeof setTimeout> | undefined;

/** Shows a text on the screen and gives it to screen readers. */
export function tell(text: string): void {
  announce(text);
  notice.value = text;
  clearTimeout(noticeTimer);
  noticeTimer = setTimeout(() => {
    notice.value = '';
  }, notice_ms);
}

/** Text for screen readers. They speak it after their present text. */
export const announcement = signal('');
export const announce = (text: string): void => {
  announcement.value = text;
};
