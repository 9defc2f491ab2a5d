import { signal } from '@preact/signals';
import type { IcebergDrift, Position } from '../api/types';
import { destination, inverse } from '../geo/geodesic';

/** Where the bergs in view are expected, from their last sightings on. */
export const drifts = signal<IcebergDrift[]>([]);

export interface Expected {
  place: Position;
  error_m: number;
}

/** Where a berg is expected at a moment; undefined before its sighting and after the end of its forecast. */
export function expectedAt({ time, lon, lat, error_m }: IcebergDrift, at_ms: number): Expected | undefined {
  const after = time.findIndex((text) => Date.parse(text) >= at_ms);
  if (after < 0) return undefined;
  const placeOf = (i: number): Position => [lon[i] ?? NaN, lat[i] ?? NaN];
  const [before_ms, after_ms] = [Date.parse(time[after - 1] ?? ''), Date.parse(time[after] ?? '')];
  if (after_ms === at_ms) return { place: placeOf(after), error_m: error_m[after] ?? NaN };
  if (after === 0) return undefined;
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
