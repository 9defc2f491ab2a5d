import { signal } from '@preact/signals';
import type { Dataset, DatasetKind, Infeasible, Plan } from '../api/types';
import { boxAround, intersection } from '../geo/boxes';
import { datasets } from './datasets';
import { routeOf } from './plans';

/** What changes from day to day; depths and coastlines do not go stale. */
const changing: DatasetKind[] = ['icebergs', 'currents', 'ice'];

/** Datasets that came in after a plan was made, of a kind that it used and where it goes. */
export function newerThan(plan: Plan, stored: Dataset[]): Dataset[] {
  const around = boxAround(routeOf(plan));
  if (!plan.created || !around) return [];
  const created_ms = Date.parse(plan.created);
  return changing.flatMap((kind) => {
    if (!plan.datasets.some((used) => used.kind === kind)) return [];
    const newer = stored.find(
      (one) => one.kind === kind && Date.parse(one.ingested) > created_ms && intersection(one.bbox, around) !== undefined,
    );
    return newer && !plan.datasets.some(({ id }) => id === newer.id) ? [newer] : [];
  });
}

export const staleness = (plan: Plan): Dataset[] => newerThan(plan, datasets.value ?? []);

/** What came of checking a plan against the newest data, by plan id. */
export type Recheck = { state: 'pending' } | { state: 'ok'; plan: Plan } | { state: 'infeasible'; answer: Infeasible } | { state: 'failed'; detail: string };

export const rechecks = signal<Record<string, Recheck>>({});
