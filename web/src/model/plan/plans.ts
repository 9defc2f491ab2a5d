import { computed, signal } from '@preact/signals';
import type { Position } from '../../contract/data_types';
import type { Plan } from '../../contract/types';
import { inverse, destination } from '../../geo/geodesic';
import { setTime, time_ms } from '../clock';
import { remember } from '../undo';

/** All stored plans, newest first. */
export const plans = signal<Plan[]>([]);

/** Ids of the plans drawn on the map. */
export const shown = signal<string[]>([]);
export const selectedId = signal<string | undefined>(undefined);
export const baselineId = signal<string | undefined>(undefined);
export const selectedWaypoint = signal<number | undefined>(undefined);

export interface ShownPlan {
  plan: Plan;
  letter: string;
  style: number; // from 0: which colour and dash pattern
}

const letters = 26;
const letterOf = (place: number): string => String.fromCharCode(65 + (place % letters));

/** The place in the alphabet of each plan that was on the map. A plan keeps its place, and therefore its letter and colour, as long as it is listed. */
const places = new Map<string, number>();

/** The first free letter; where there is none, that of a plan that is not on the map. */
function placeOf(id: string): number {
  const known = places.get(id);
  if (known !== undefined) return known;
  const taken = new Set(places.values());
  let free = 0;
  while (taken.has(free)) ++free;
  const hidden = free < letters ? undefined : [...places].find(([other]) => !shown.value.includes(other));
  if (hidden) places.delete(hidden[0]);
  const place = hidden?.[1] ?? free;
  places.set(id, place);
  return place;
}

export const shownPlans = computed<ShownPlan[]>(() => {
  const listed = new Set([...shown.value, ...plans.value.map(({ plan_id }) => plan_id)]);
  for (const id of places.keys()) if (!listed.has(id)) places.delete(id);
  return shown.value.flatMap((id) => {
    const plan = plans.value.find((candidate) => candidate.plan_id === id);
    const place = placeOf(id);
    return plan ? [{ plan, letter: letterOf(place), style: place }] : [];
  });
});

export const selectedPlan = computed(() => plans.value.find((plan) => plan.plan_id === selectedId.value));
export const selectedShown = computed(() => shownPlans.value.find(({ plan }) => plan.plan_id === selectedId.value));

/** The plan that others are compared with: the chosen one, else the first on the map. */
export const baseline = computed(
  () => shownPlans.value.find(({ plan }) => plan.plan_id === baselineId.value)?.plan ?? shownPlans.value[0]?.plan,
);

export function show(id: string, on: boolean): void {
  const without = shown.value.filter((other) => other !== id);
  shown.value = on ? [...without, id] : without;
  if (!on && selectedId.value === id) selectedId.value = without.at(-1);
}

/** Selects a plan and makes sure that it is on the map. */
export function select(id: string | undefined): void {
  if (id !== undefined && !shown.value.includes(id)) shown.value = [...shown.value, id];
  selectedId.value = id;
  selectedWaypoint.value = undefined;
}

/** What is on the map, what is selected and the clock's time, as a function that brings them back. Plans deleted by then stay away. */
function currentSight(): () => void {
  const [ids, selected, at_ms] = [shown.peek(), selectedId.peek(), time_ms.peek()];
  return () => {
    const listed = new Set(plans.peek().map(({ plan_id }) => plan_id));
    shown.value = ids.filter((id) => listed.has(id));
    select(selected !== undefined && listed.has(selected) ? selected : undefined);
    setTime(at_ms);
  };
}

/**
 * Adds a new plan and selects it, with its alternatives below it in the list and beside it on the map. Undo brings back
 * the sight before. The plan stays in the list, because the server has stored it.
 */
export function add(plan: Plan, alternatives: Plan[] = []): void {
  let other = currentSight();
  const swap = (): void => {
    const now = currentSight();
    other();
    other = now;
  };
  remember({ title: `planning ${titleOf(plan)}, which stays in the list`, of: plan.plan_id, back: swap, again: swap });
  const added = [plan, ...alternatives];
  const ids = added.map(({ plan_id }) => plan_id);
  plans.value = [...added, ...plans.value.filter(({ plan_id }) => !ids.includes(plan_id))];
  select(plan.plan_id);
  shown.value = [...shown.value, ...ids.filter((id) => !shown.value.includes(id))];
}

/** The newest plan first, and alternatives below the plan that they belong to. `stored`: as the server lists them, the oldest first. */
export function inOrder(stored: Plan[]): Plan[] {
  const newestFirst = [...stored].reverse().sort((a, b) => Date.parse(b.created ?? b.departure) - Date.parse(a.created ?? a.departure));
  const below = new Set(newestFirst.flatMap(({ alternatives = [] }) => alternatives.map(({ plan_id }) => plan_id)));
  const ordered = newestFirst.filter(({ plan_id }) => !below.has(plan_id)).flatMap((plan) => [
    plan,
    ...(plan.alternatives ?? []).flatMap(({ plan_id }) => stored.filter((other) => other.plan_id === plan_id)),
  ]);
  return [...new Set(ordered)]; // the same route may be an alternative to two plans
}

export function forget(id: string): void {
  plans.value = plans.value.filter((plan) => plan.plan_id !== id);
  show(id, false);
}

/** Brings back a forgotten plan: in its place in the list, on the map and selected as before. */
export function bringBack(plan: Plan, index: number, isShown: boolean, isSelected: boolean): void {
  plans.value = [...plans.value.slice(0, index), plan, ...plans.value.slice(index)];
  if (isShown) show(plan.plan_id, true);
  if (isSelected) select(plan.plan_id);
}

export interface OnTheWay {
  place: Position;
  course_deg: number;
  leg: number; // index of the waypoint at the end of the leg
}

/** Where the vehicle of a plan is at a moment; undefined before departure and after arrival. */
export function vehicleAt(plan: Plan, at_ms: number): OnTheWay | undefined {
  const next = plan.waypoints.findIndex((waypoint, i) => i > 0 && Date.parse(waypoint.eta) >= at_ms);
  const from = plan.waypoints[next - 1];
  const to = plan.waypoints[next];
  if (!from || !to || at_ms < Date.parse(from.eta)) return undefined;
  const leg = inverse([from.lon, from.lat], [to.lon, to.lat]);
  const leaves_ms = Date.parse(from.eta) + 1000 * (from.wait_s ?? 0);
  const share = Math.max(0, at_ms - leaves_ms) / Math.max(1, Date.parse(to.eta) - leaves_ms);
  const place = destination([from.lon, from.lat], leg.azimuth_deg, leg.distance_m * share);
  return { place, course_deg: leg.azimuth_deg, leg: next };
}

/** Which leg the selected plan is on at the clock's time. It changes once a leg, not at each tick. */
export const legUnderWay = computed(() => selectedPlan.value && vehicleAt(selectedPlan.value, time_ms.value)?.leg);

/** The name of a waypoint: S for the start, then 1, 2, …, equal to the JSON indices and the rows of mission files. */
export const waypointLabel = (index: number): string => (index === 0 ? 'S' : String(index));

export const routeOf = (plan: Plan): Position[] => plan.waypoints.map(({ lon, lat }) => [lon, lat]);

/** Whether ice covers the start, so that no vehicle can be launched there; not known of plans that were made without ice. */
export const startsUnderIce = ({ waypoints }: Plan): boolean => waypoints[0]?.may_surface === false;

/** "Plan 4": a name for a plan without one: one past the highest number in use. */
export function nextName(): string {
  const numbers = plans.value.map(({ name }) => Number(/^Plan (\d+)$/.exec(name)?.[1] ?? 0));
  return `Plan ${Math.max(0, ...numbers) + 1}`;
}

export const titleOf = (plan: Plan): string => plan.name || `Plan ${plan.plan_id.slice(0, 8)}`;
