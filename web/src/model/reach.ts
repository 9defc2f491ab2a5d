import { signal } from '@preact/signals';
import type { Conditions, Reach } from '../api/types';

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

const ofTheRoute = new Set(['objective', 'thruster', 'require_battery', 'max_loiter_s']);
const ofPassingIce = new Set(['max_concentration_to_surface', 'margin_below_ice_m', 'draft_if_unknown_m', 'max_time_without_surfacing_s']);

/** Of what a plan is made under, that which matters to where the vehicle comes. */
export function conditionsOfReach({ under_ice, ...others }: Conditions): Conditions {
  const kept: Conditions = Object.fromEntries(Object.entries(others).filter(([name]) => !ofTheRoute.has(name)));
  const passing = Object.fromEntries(Object.entries(under_ice ?? {}).filter(([name]) => ofPassingIce.has(name)));
  return Object.keys(passing).length > 0 ? { ...kept, under_ice: passing } : kept;
}
