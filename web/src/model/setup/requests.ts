import type { Conditions, Plan, PlanInputs } from '../../contract/types';
import { isCondition } from '../fields';
import { draft, numberIn } from './draft';
import { staleness } from '../stale';

/** The requests of plans, by plan id: of plans made in this browser, and of plans whose request was asked of the server. */
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

/** The oldest are dropped when the browser's storage is full. Files with goals may take much of it. */
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
const several = new Set<string>(['currents', 'bathymetry', 'icebergs']);

/**
 * The choice of data with which the server uses the data of the plan again, and none of a kind that the plan did not use. Two kinds of data are not
 * named, so the server joins them again: runs of one product, because named runs would be members of an ensemble; and sightings if none are newer,
 * because the server refuses a named file without a sighting near the route.
 */
export function dataOf(plan: Plan, icebergs: PlanInputs['icebergs'] = 'newest'): Pick<PlanInputs, (typeof kinds)[number]> {
  const choiceOf = (kind: (typeof kinds)[number]): string | string[] => {
    const used = plan.datasets.filter((dataset) => dataset.kind === kind);
    const ids = used.map(({ id }) => id);
    if (kind === 'icebergs' && icebergs === 'newest' && !staleness(plan).some((newer) => newer.kind === kind)) return 'newest';
    if (ids.length <= 1) return ids[0] ?? 'none';
    return several.has(kind) && used.every(({ from }) => from === undefined) ? ids : 'newest';
  };
  return Object.fromEntries(kinds.map((kind) => [kind, choiceOf(kind)]));
}

/** A request without its start, goal and via points: the conditions under which a route is evaluated. */
export const conditionsIn = (inputs: PlanInputs): Conditions =>
  Object.fromEntries(Object.entries(inputs).filter(([name]) => isCondition(name)));

const ofTheWindow = new Set<string>(['depart_until', 'depart_step', 'arrive_by', 'name'] satisfies (keyof PlanInputs)[]);

/** The same request for one departure. */
export const withDeparture = (inputs: PlanInputs, departure: string): PlanInputs => ({
  ...(Object.fromEntries(Object.entries(inputs).filter(([name]) => !ofTheWindow.has(name))) as unknown as PlanInputs),
  depart: departure,
});

/**
 * The conditions under which a plan's route is evaluated: those of its own request, or, where that is not known, its vehicle and the
 * margin of the set-up. In both cases with its departure and its data.
 */
export function conditionsOf(plan: Plan): { conditions: Conditions; known: boolean } {
  const inputs = requestOf(plan.plan_id);
  const margin_m = numberIn(draft.value.margin_m);
  const guessed = { vehicle: plan.vehicle, ...(margin_m === undefined ? {} : { margin_m }) };
  const conditions = { ...(inputs ? conditionsIn(inputs) : guessed), ...dataOf(plan, inputs?.icebergs), depart: plan.departure };
  return { conditions, known: inputs !== undefined };
}
