import { computed, signal } from '@preact/signals';
import type { Position } from '../api/data_types';
import type { Conditions, Infeasible, Plan } from '../api/types';
import { destination, inverse } from '../geo/geodesic';
import { begin, record, redo, undo, type History } from './history';
import { routeOf, selectedId, selectedWaypoint } from './plans';
import { conditionsOf } from './requests';

/** What the server says of the route as it now is. */
export type Verdict =
  | { state: 'pending' }
  | { state: 'ok'; plan: Plan }
  | { state: 'infeasible'; answer: Infeasible }
  | { state: 'failed'; detail: string };

/** A copy of a plan's route under change; the plan itself is never touched. */
export interface RouteEdit {
  origin: Plan;
  conditions: Conditions;
  conditionsKnown: boolean; // false: the plan's own request is not known here, and the set-up's margin stands in
  route: History<Position[]>;
  number: number; // of the route as it now is; an answer to an earlier number is ignored
  verdict: Verdict;
  figures: Plan; // of the last route that could be evaluated, perhaps not this one
}

export const routeEdit = signal<RouteEdit | undefined>(undefined);

/** The edit in view: that of the selected plan. */
export const openEdit = computed(() => (routeEdit.value?.origin.plan_id === selectedId.value ? routeEdit.value : undefined));

export function startEdit(plan: Plan): void {
  const { conditions, known } = conditionsOf(plan);
  routeEdit.value = {
    origin: plan, conditions, conditionsKnown: known, route: begin(routeOf(plan)), number: 0,
    verdict: { state: 'ok', plan }, figures: plan,
  };
}

export function discardEdit(): void {
  routeEdit.value = undefined;
}

function become(route: History<Position[]>): void {
  const edit = routeEdit.value;
  if (!edit || route === edit.route) return;
  routeEdit.value = { ...edit, route, number: edit.number + 1, verdict: { state: 'pending' } };
  const last = route.now.length - 1;
  if (selectedWaypoint.value !== undefined && selectedWaypoint.value > last) selectedWaypoint.value = last;
}

function change(next: (route: Position[]) => Position[]): void {
  const edit = routeEdit.value;
  if (edit) become(record(edit.route, next(edit.route.now)));
}

export const moveWaypoint = (index: number, place: Position): void =>
  change((route) => route.map((old, i) => (i === index ? place : old)));

/** Puts a new waypoint before number `index`, which then has that number, and selects it. */
export function insertWaypoint(index: number, place: Position): void {
  change((route) => [...route.slice(0, index), place, ...route.slice(index)]);
  selectedWaypoint.value = index;
}

/** Puts one half-way along the leg that leaves `index`, or along the last leg. */
export function insertAfter(index: number): void {
  const route = routeEdit.value?.route.now ?? [];
  const first = Math.min(index, route.length - 2);
  const [from, to] = [route[first], route[first + 1]];
  if (from && to) insertWaypoint(first + 1, halfway(from, to));
}

export const canRemove = (): boolean => (routeEdit.value?.route.now.length ?? 0) > 2;

/** Takes one out; two must remain. */
export function removeWaypoint(index: number): void {
  if (canRemove()) change((route) => route.filter((_, i) => i !== index));
}

export function undoEdit(): void {
  if (routeEdit.value) become(undo(routeEdit.value.route));
}

export function redoEdit(): void {
  if (routeEdit.value) become(redo(routeEdit.value.route));
}

/** Takes an answer in, unless the route has changed since it was asked for. */
export function deliver(number: number, verdict: Verdict): boolean {
  const edit = routeEdit.value;
  if (edit?.number !== number) return false;
  routeEdit.value = { ...edit, verdict, figures: verdict.state === 'ok' ? verdict.plan : edit.figures };
  return true;
}

export function halfway(from: Position, to: Position): Position {
  const leg = inverse(from, to);
  return destination(from, leg.azimuth_deg, leg.distance_m / 2);
}

/** Why the edited route cannot become a plan now; undefined when it can. */
export function whyNotSaved({ verdict, number }: RouteEdit): string | undefined {
  if (verdict.state === 'pending') return 'Its figures are being worked out.';
  if (verdict.state === 'infeasible') return 'It cannot be flown as it is.';
  if (verdict.state === 'failed') return 'Its figures could not be worked out.';
  return number === 0 ? 'Nothing has been changed yet.' : undefined;
}
