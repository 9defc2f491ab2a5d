import { signal } from '@preact/signals';
import type { IcebergDrift, Position } from '../../contract/data_types';
import { destination, inverse } from '../../geo/geodesic';

/** Forecasts of the icebergs in view, from their last sightings on. */
export const drifts = signal<IcebergDrift[]>([]);

/** The number of icebergs in view beyond the server's limit for one answer. */
export const driftsLeftOut = signal(0);

export interface Expected {
  place: Position;
  error_m: number;
}

/** The times of a forecast, cached because each clock step needs them for every iceberg, and the step that was asked for last. */
interface Moments {
  at_ms: number[];
  after: number;
}

const known = new WeakMap<IcebergDrift, Moments>();

function momentsOf(drift: IcebergDrift): Moments {
  const found = known.get(drift);
  if (found) return found;
  const moments = { at_ms: drift.time.map((text) => Date.parse(text)), after: 0 };
  known.set(drift, moments);
  return moments;
}

/** The index of the first of ascending times that is not before a moment; their number where all are before it. */
function firstFrom(moments_ms: number[], at_ms: number): number {
  let [low, high] = [0, moments_ms.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((moments_ms[middle] ?? NaN) < at_ms) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Between which two steps of a forecast a moment lies: the later step, and the share of the time that has passed up to it. Undefined
 * before the sighting and after the end. */
export function stepsAt(drift: IcebergDrift, at_ms: number): { after: number; share: number } | undefined {
  const moments = momentsOf(drift);
  const moments_ms = moments.at_ms;
  const isSame = (moments_ms[moments.after - 1] ?? NaN) < at_ms && at_ms <= (moments_ms[moments.after] ?? NaN);
  if (!isSame) moments.after = firstFrom(moments_ms, at_ms);
  const { after } = moments;
  const after_ms = moments_ms[after];
  const before_ms = moments_ms[after - 1];
  if (after_ms === undefined) return undefined;
  if (after_ms === at_ms) return { after, share: 1 };
  return before_ms === undefined ? undefined : { after, share: (at_ms - before_ms) / (after_ms - before_ms) };
}

/** The position error of an iceberg at a moment. */
export function errorAt({ error_m }: IcebergDrift, { after, share }: { after: number; share: number }): number {
  const most_m = error_m[after] ?? NaN;
  return share === 1 ? most_m : (1 - share) * (error_m[after - 1] ?? NaN) + share * most_m;
}

/** The expected position of a berg at a time. */
export function expectedAt(drift: IcebergDrift, at_ms: number): Expected | undefined {
  const { lon, lat } = drift;
  const steps = stepsAt(drift, at_ms);
  if (!steps) return undefined;
  const placeOf = (i: number): Position => [lon[i] ?? NaN, lat[i] ?? NaN];
  const error_m = errorAt(drift, steps);
  if (steps.share === 1) return { place: placeOf(steps.after), error_m };
  const [from, to] = [placeOf(steps.after - 1), placeOf(steps.after)];
  const leg = inverse(from, to);
  return { place: leg.distance_m === 0 ? from : destination(from, leg.azimuth_deg, steps.share * leg.distance_m), error_m };
}

/** The forecast track of a berg. */
export const driftLineOf = ({ lon, lat }: IcebergDrift): Position[] => lon.map((x, i) => [x, lat[i] ?? NaN]);

/**
 * The track without the tide, for maps of a small scale: the first and last place, and places one period of M2 apart.
 */
export function plainLineOf(drift: IcebergDrift): Position[] {
  const line = driftLineOf(drift);
  const moments_ms = momentsOf(drift).at_ms;
  const [start_ms, end_ms] = [moments_ms[0], moments_ms.at(-1)];
  if (start_ms === undefined || end_ms === undefined) return line;
  return [...line.slice(0, 1), ...placesEvery(tide_ms, drift, start_ms, end_ms - 1), ...line.slice(1).slice(-1)];
}

/** The period of the principal lunar tide: 12 h 25 min 14 s. */
const tide_ms = 44_714_000;

const tick_ms = 6 * 3_600_000;

/** The places of a forecast every six hours after the sighting. */
export const ticksOf = (drift: IcebergDrift): Position[] => placesEvery(tick_ms, drift, Date.parse(drift.observed), Date.parse(drift.time.at(-1) ?? ''));

function placesEvery(step_ms: number, drift: IcebergDrift, start_ms: number, end_ms: number): Position[] {
  const places: Position[] = [];
  for (let at_ms = start_ms + step_ms; at_ms <= end_ms; at_ms += step_ms) {
    const expected = expectedAt(drift, at_ms);
    if (expected) places.push(expected.place);
  }
  return places;
}
