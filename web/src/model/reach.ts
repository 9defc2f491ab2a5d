import { signal } from '@preact/signals';
import type { Conditions, Reach } from '../contract/types';
import { isOfReach } from './fields';

/** Isochrones from the start: the hours as typed, and the server's answer for the map. */
export const reachHours = signal('6, 12, 24');

export type ReachState = { state: 'pending' } | { state: 'ok'; answer: Reach } | { state: 'failed'; detail: string };

export const reach = signal<ReachState | undefined>(undefined);

/** Reads a list of hours; undefined where one cannot be read. */
export function hoursIn(text: string): number[] | undefined {
  const words = text.split(/[\s,;]+/).filter((word) => word !== '');
  const hours = words.map(Number);
  return hours.length > 0 && hours.every((hour) => hour > 0) ? [...new Set(hours)].sort((a, b) => a - b) : undefined;
}

/** The conditions of a plan that also matter to isochrones. */
export function conditionsOfReach({ under_ice, ...others }: Conditions): Conditions {
  const kept: Conditions = Object.fromEntries(Object.entries(others).filter(([name]) => isOfReach(name)));
  const passing = Object.fromEntries(Object.entries(under_ice ?? {}).filter(([name]) => isOfReach(`under_ice.${name}`)));
  return Object.keys(passing).length > 0 ? { ...kept, under_ice: passing } : kept;
}
