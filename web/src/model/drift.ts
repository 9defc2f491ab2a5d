import { signal } from '@preact/signals';
import type { IcebergDrift, Position } from '../api/data_types';
import { destination, inverse } from '../geo/geodesic';

/** Where the bergs in view are expected, from their last sightings on. */
export const drifts = signal<IcebergDrift[]>([]);

export interface Expected {
  place: Position;
  error_m: number;
}

const known = new WeakMap<IcebergDrift, number[]>();

/** The moments of a forecast; read once, because every step of the clock asks every berg. */
function momentsOf(drift: IcebergDrift): number[] {
  const moments_ms = known.get(drift) ?? drift.time.map((text) => Date.parse(text));
  known.set(drift, moments_ms);
  return moments_ms;
}

/** The first of ascending moments that is not before another; as many as there are when all are. */
function firstFrom(moments_ms: number[], at_ms: number): number {
  let [low, high] = [0, moments_ms.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((moments_ms[middle] ?? NaN) < at_ms) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Where a berg is expected at a moment; undefined before its sighting and after the end of its forecast. */
export function expectedAt(drift: IcebergDrift, at_ms: number): Expected | undefined {
  const { lon, lat, error_m } = drift;
  const moments_ms = momentsOf(drift);
  const after = firstFrom(moments_ms, at_ms);
  const [before_ms, after_ms] = [moments_ms[after - 1], moments_ms[after]];
  if (after_ms === undefined) return undefined;
  const placeOf = (i: number): Position => [lon[i] ?? NaN, lat[i] ?? NaN];
  if (after_ms === at_ms) return { place: placeOf(after), error_m: error_m[after] ?? NaN };
  if (before_ms === undefined) return undefined;
  const share = (at_ms - before_ms) / (after_ms - before_ms);
  const [from, to] = [placeOf(after - 1), placeOf(after)];
  const leg = inverse(from, to);
  const [least, most] = [error_m[after - 1] ?? NaN, error_m[after] ?? NaN];
  return {
    place: leg.distance_m === 0 ? from : destination(from, leg.azimuth_deg, share * leg.distance_m),
    error_m: least + share * (most - least),
  };
}

/** The way of a berg as far as it is forecast, and its places every six hours after the sighting. */
export const wayOf = ({ lon, lat }: IcebergDrift): Position[] => lon.map((x, i) => [x, lat[i] ?? NaN]);

const tick_ms = 6 * 3_600_000;

export function ticksOf(drift: IcebergDrift): Position[] {
  const start_ms = Date.parse(drift.observed);
  const end_ms = Date.parse(drift.time.at(-1) ?? '');
  const ticks: Position[] = [];
  for (let at_ms = start_ms + tick_ms; at_ms <= end_ms; at_ms += tick_ms) {
    const expected = expectedAt(drift, at_ms);
    if (expected) ticks.push(expected.place);
  }
  return ticks;
}
