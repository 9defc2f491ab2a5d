import type { Conditions, Plan, PlanInputs } from '../api/types';
import { draft, numberIn } from './draft';

/** The requests that plans came from, by plan id, as far as they were made in this browser: a stored plan does not say. */
const key = 'floeplan.requests';
const most = 100;

type Remembered = [id: string, inputs: PlanInputs][];

function stored(): Remembered {
  try {
    const read: unknown = JSON.parse(localStorage.getItem(key) ?? '[]');
    return Array.isArray(read) ? (read as Remembered) : [];
  } catch {
    return [];
  }
}

/** The oldest give way where the browser's room, of which files with goals may take much, ends. */
export function rememberRequest(planId: string, inputs: PlanInputs): void {
  const others = stored().filter(([id]) => id !== planId);
  for (let kept: Remembered = [[planId, inputs] as Remembered[number], ...others].slice(0, most); kept.length > 0; kept = kept.slice(0, Math.floor(kept.length / 2))) {
    try {
      localStorage.setItem(key, JSON.stringify(kept));
      return;
    } catch {
      // A browser that refuses storage only forgets under which conditions its plans were made.
    }
  }
}

export const requestOf = (planId: string): PlanInputs | undefined => stored().find(([id]) => id === planId)?.[1];

const kinds = ['currents', 'bathymetry', 'ice', 'icebergs', 'coastline'] as const;

/** The very data that a plan was computed on, and none of a kind that it did without. */
export function dataOf(plan: Plan): Pick<PlanInputs, (typeof kinds)[number]> {
  const idsOf = (kind: string): string[] => plan.datasets.filter((dataset) => dataset.kind === kind).map(({ id }) => id);
  const currents = idsOf('currents');
  const icebergs = idsOf('icebergs');
  return {
    currents: currents.length > 1 ? currents : (currents[0] ?? 'none'),
    ...Object.fromEntries(kinds.slice(1).map((kind) => [kind, idsOf(kind)[0] ?? 'none'])),
    ...(icebergs.length > 1 ? { icebergs } : {}),
  };
}

const ofTheWay = new Set<string>([
  'from', 'to', 'via', 'via_order', 'goals_file', 'spacing_m', 'sectors', 'method', 'max_waypoints', 'max_leg_m', 'refine', 'refine_seconds',
  'encounter_weight_s', 'uncertainty', 'depart_until', 'depart_step', 'arrive_by', 'optimality_gap', 'name',
] satisfies Exclude<keyof PlanInputs, keyof Conditions>[]);

/** Everything of a request but the way: what a route is judged under. */
export const conditionsIn = (inputs: PlanInputs): Conditions =>
  Object.fromEntries(Object.entries(inputs).filter(([name]) => !ofTheWay.has(name)));

const ofTheWindow = new Set<string>(['depart_until', 'depart_step', 'arrive_by', 'name'] satisfies (keyof PlanInputs)[]);

/** The same request for one departure. */
export const withDeparture = (inputs: PlanInputs, departure: string): PlanInputs => ({
  ...(Object.fromEntries(Object.entries(inputs).filter(([name]) => !ofTheWindow.has(name))) as unknown as PlanInputs),
  depart: departure,
});

/**
 * What a plan's route is judged under: its own request where this browser made it, else its vehicle and the margin of
 * the set-up; at its departure and on its data in either case.
 */
export function conditionsOf(plan: Plan): { conditions: Conditions; known: boolean } {
  const inputs = requestOf(plan.plan_id);
  const margin_m = numberIn(draft.value.margin_m);
  const guessed = { vehicle: plan.vehicle, ...(margin_m === undefined ? {} : { margin_m }) };
  const conditions = { ...(inputs ? conditionsIn(inputs) : guessed), ...dataOf(plan), depart: plan.departure };
  return { conditions, known: inputs !== undefined };
}
