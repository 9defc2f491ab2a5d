import type { Conditions, Plan, PlanInputs } from '../api/types';
import { isCondition } from './fields';
import { draft, numberIn } from './draft';
import { staleness } from './stale';

/** The requests that plans came from, by plan id: of those made in this browser, and of those that the server was asked about. */
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
const several = new Set<string>(['currents', 'bathymetry', 'icebergs']);

/**
 * The very data that a plan was computed on, and none of a kind that it did without. What the server joins by itself it is left
 * to join again: runs of one product, which by name would be members of an ensemble, and sightings as long as none are newer,
 * because those of a file that has nothing near a route cannot be named for it.
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

/** Everything of a request but the way: what a route is judged under. */
export const conditionsIn = (inputs: PlanInputs): Conditions =>
  Object.fromEntries(Object.entries(inputs).filter(([name]) => isCondition(name)));

const ofTheWindow = new Set<string>(['depart_until', 'depart_step', 'arrive_by', 'name'] satisfies (keyof PlanInputs)[]);

/** The same request for one departure. */
export const withDeparture = (inputs: PlanInputs, departure: string): PlanInputs => ({
  ...(Object.fromEntries(Object.entries(inputs).filter(([name]) => !ofTheWindow.has(name))) as unknown as PlanInputs),
  depart: departure,
});

/**
 * What a plan's route is judged under: its own request where it is known, else its vehicle and the margin of
 * the set-up; at its departure and on its data in either case.
 */
export function conditionsOf(plan: Plan): { conditions: Conditions; known: boolean } {
  const inputs = requestOf(plan.plan_id);
  const margin_m = numberIn(draft.value.margin_m);
  const guessed = { vehicle: plan.vehicle, ...(margin_m === undefined ? {} : { margin_m }) };
  const conditions = { ...(inputs ? conditionsIn(inputs) : guessed), ...dataOf(plan, inputs?.icebergs), depart: plan.departure };
  return { conditions, known: inputs !== undefined };
}
