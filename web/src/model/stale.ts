import { signal } from '@preact/signals';
import type { Box, Dataset, DatasetKind } from '../contract/data_types';
import type { Infeasible, Plan } from '../contract/types';
import { boxAround, intersection } from '../geo/boxes';
import { wrapLongitude } from '../geo/geodesic';
import { datasets } from './datasets';
import { routeOf } from './plan/plans';
import { oldestThatCounts_ms, sighting_days } from './setup/sighting_age';

/** Kinds of data that change from day to day. Depths and coastlines do not become stale. */
const changing: DatasetKind[] = ['icebergs', 'currents', 'ice', 'zones'];

/** How far outside the area of a plan the planner takes icebergs into account: a hundred kilometres. */
const drift_deg = 0.9;

/** Whether a dataset matters to a plan of that time: sightings that are neither too old nor later than the departure, currents of its hours. */
function speaksThen({ kind, time_start, time_end }: Dataset, plan: Plan): boolean {
  if (kind === 'currents') {
    return (!time_start || Date.parse(time_start) <= Date.parse(plan.arrival)) && (!time_end || Date.parse(time_end) >= Date.parse(plan.departure));
  }
  if (kind !== 'icebergs') return true;
  const [oldest_ms, newest_ms] = sightingsFor(plan);
  return (!time_start || Date.parse(time_start) <= newest_ms) && (!time_end || Date.parse(time_end) >= oldest_ms);
}

/** The period whose sightings count. It ends at the departure, or now for a plan under way. */
export function sightingsFor({ departure, arrival, sightings }: Plan, now_ms = Date.now()): [oldest_ms: number, newest_ms: number] {
  const depart_ms = Date.parse(departure);
  const isUnderWay = now_ms > depart_ms && now_ms < Date.parse(arrival);
  return [oldestThatCounts_ms(depart_ms, sightings?.max_age_days ?? sighting_days), isUnderWay ? now_ms : depart_ms];
}

/** The area of a dataset; for icebergs together with the water that they may drift into. */
function reachOf({ bbox: [west, south, east, north], kind }: Dataset): Box {
  if (kind !== 'icebergs') return [west, south, east, north];
  const aside_deg = drift_deg / Math.cos((Math.min(89, Math.max(Math.abs(south), Math.abs(north))) * Math.PI) / 180);
  return [wrapLongitude(west - aside_deg), south - drift_deg, wrapLongitude(east + aside_deg), north + drift_deg];
}

/**
 * Datasets of the plan's area that were stored, or changed by hand, after the plan was made, of the kinds that it used. Zones and
 * icebergs close routes, so they count even if the plan used none.
 */
export function newerThan(plan: Plan, stored: Dataset[]): Dataset[] {
  const around = boxAround(routeOf(plan));
  if (!plan.created || !around) return [];
  const created_ms = Date.parse(plan.created);
  return changing.flatMap((kind) => {
    const isUsed = plan.datasets.some((used) => used.kind === kind);
    const newer = stored.filter(
      (one) => one.kind === kind && Date.parse(one.ingested) > created_ms && intersection(reachOf(one), around) !== undefined && speaksThen(one, plan),
    );
    const isJoined = kind === 'zones' || kind === 'icebergs';
    const counting = isJoined ? newer : isUsed ? newer.slice(0, 1) : [];
    return counting.filter((one) => !plan.datasets.some(({ id, sha256 }) => id === one.id && sha256 === one.sha256));
  });
}

export const staleness = (plan: Plan): Dataset[] => newerThan(plan, datasets.value ?? []);

/** Results of checking plans against the newest data, by plan id. */
export type Recheck = { state: 'pending' } | { state: 'ok'; plan: Plan } | { state: 'infeasible'; answer: Infeasible } | { state: 'failed'; detail: string };

export const rechecks = signal<Record<string, Recheck>>({});
