import { computed, signal } from '@preact/signals';
import type { Position } from '../../contract/data_types';
import type { Conditions, Infeasible, Plan } from '../../contract/types';
import { destination, inverse } from '../../geo/geodesic';
import { routeOf, select, selectedId, selectedWaypoint, titleOf, waypointLabel } from './plans';
import { conditionsOf } from '../setup/requests';
import { forgetChanges, remember } from '../undo';

/** The server's answer for the present route. */
export type Verdict =
  | { state: 'pending' }
  | { state: 'ok'; plan: Plan }
  | { state: 'infeasible'; answer: Infeasible }
  | { state: 'failed'; detail: string };

/** An edited copy of a plan's route; the plan itself does not change. */
export interface RouteEdit {
  key: string; // of its changes for undo
  origin: Plan;
  conditions: Conditions;
  conditionsKnown: boolean; // false: the plan's own request is unknown, so the set-up's margin is used
  route: Position[];
  number: number; // grows with each change of the route; an answer to an earlier number is ignored
  verdict: Verdict;
  figures: Plan; // the last plan that could be evaluated, possibly of an earlier route
}

export const routeEdit = signal<RouteEdit | undefined>(undefined);

/** The edit in view: that of the selected plan. */
export const openEdit = computed(() => (routeEdit.value?.origin.plan_id === selectedId.value ? routeEdit.value : undefined));

/** How many edits were opened. */
let opened = 0;

const isUnchanged = ({ route, origin }: RouteEdit): boolean =>
  route.length === origin.waypoints.length && route.every(([lon, lat], i) => lon === origin.waypoints[i]?.lon && lat === origin.waypoints[i].lat);

/** Opens the edit of a plan and closes the one before. Undo brings that back. */
export function startEdit(plan: Plan): void {
  discardEdit();
  const { conditions, known } = conditionsOf(plan);
  routeEdit.value = {
    key: `edit ${++opened}`, origin: plan, conditions, conditionsKnown: known, route: routeOf(plan), number: 0, verdict: { state: 'ok', plan }, figures: plan,
  };
}

/** Discards the changes. Undo brings them back; where all have been undone, there is nothing to bring back. */
export function discardEdit(): void {
  const edit = routeEdit.peek();
  if (!edit) return;
  routeEdit.value = undefined;
  if (isUnchanged(edit)) {
    forgetChanges(edit.key);
    return;
  }
  const back = (): void => {
    routeEdit.value = edit.verdict.state === 'pending' ? { ...edit, number: edit.number + 1 } : edit;
    select(edit.origin.plan_id);
  };
  const again = (): void => {
    routeEdit.value = undefined;
  };
  remember({ title: `discarding the changes of ${titleOf(edit.origin)}`, of: edit.key, back, again });
}

/** Ends an edit that was stored as a plan of its own. Its changes can no longer be undone. */
export function closeSavedEdit(): void {
  const edit = routeEdit.peek();
  if (edit) forgetChanges(edit.key);
  routeEdit.value = undefined;
}

/** Shows the edit with another route. */
function become(origin: Plan, route: Position[]): void {
  const edit = routeEdit.value;
  if (edit?.origin.plan_id !== origin.plan_id) return;
  routeEdit.value = { ...edit, route, number: edit.number + 1, verdict: { state: 'pending' } };
  if (selectedId.peek() !== origin.plan_id) select(origin.plan_id);
  const last = route.length - 1;
  if (selectedWaypoint.value !== undefined && selectedWaypoint.value > last) selectedWaypoint.value = last;
}

function change(title: string, next: (route: Position[]) => Position[]): void {
  const edit = routeEdit.value;
  if (!edit) return;
  const { origin, route } = edit;
  const changed = next(route);
  become(origin, changed);
  remember({ title, of: edit.key, back: () => become(origin, route), again: () => become(origin, changed) });
}

export const moveWaypoint = (index: number, place: Position): void =>
  change(`moving waypoint ${waypointLabel(index)}`, (route) => route.map((old, i) => (i === index ? place : old)));

/** Inserts a new waypoint before number `index`, which then has that number, and selects it. */
export function insertWaypoint(index: number, place: Position): void {
  change(`inserting waypoint ${waypointLabel(index)}`, (route) => [...route.slice(0, index), place, ...route.slice(index)]);
  selectedWaypoint.value = index;
}

/** Inserts a waypoint in the middle of the leg that leaves `index`, or of the last leg. */
export function insertAfter(index: number): void {
  const route = routeEdit.value?.route ?? [];
  const first = Math.min(index, route.length - 2);
  const [from, to] = [route[first], route[first + 1]];
  if (from && to) insertWaypoint(first + 1, halfway(from, to));
}

export const canRemove = (): boolean => (routeEdit.value?.route.length ?? 0) > 2;

/** Removes a waypoint; two must remain. */
export function removeWaypoint(index: number): void {
  if (canRemove()) change(`removing waypoint ${waypointLabel(index)}`, (route) => route.filter((_, i) => i !== index));
}

/** Stores an answer, unless the route has changed since it was asked for. */
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
export function whyNotSaved(edit: RouteEdit): string | undefined {
  const { verdict } = edit;
  if (verdict.state === 'pending') return 'Its figures are being worked out.';
  if (verdict.state === 'infeasible') return 'It cannot be flown as it is.';
  if (verdict.state === 'failed') return 'Its figures could not be worked out.';
  return isUnchanged(edit) ? 'Nothing has been changed yet.' : undefined;
}
