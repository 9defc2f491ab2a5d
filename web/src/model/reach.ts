import { signal } from '@preact/signals';
import type { Reach } from '../api/types';

/** How far the vehicle comes from the start: hours as typed, and the server's answer for the map. */
export const reachHours = signal('6, 12, 24');

export type ReachState = { state: 'pending' } | { state: 'ok'; answer: Reach } | { state: 'failed'; detail: string };

export const reach = signal<ReachState | undefined>(undefined);

/** Hours as people list them; undefined where one cannot be read. */
export function hoursIn(text: string): number[] | undefined {
  const words = text.split(/[\s,;]+/).filter((word) => word !== '');
  const hours = words.map(Number);
  return hours.length > 0 && hours.every((hour) => hour > 0) ? [...new Set(hours)].sort((a, b) => a - b) : undefined;
}
