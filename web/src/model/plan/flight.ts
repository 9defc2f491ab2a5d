import type { Flight, FlightEnd, FlightMode, SimulationSummary } from '../../contract/simulation_types';
import type { Position } from '../../contract/data_types';
import type { Plan } from '../../contract/types';
import { destination, inverse } from '../../geo/geodesic';
import { routeOf } from './plans';

/** Where a simulated vehicle is, and where its dead reckoning puts it. */
export interface Moment {
  place: Position;
  believed: Position;
  sigma_m: number;
  depth_m: number;
  heading_deg: number;
  mode: FlightMode;
  atSurface: boolean;
}

const secondsOf = ({ departure }: Flight, at_ms: number): number => (at_ms - Date.parse(departure)) / 1000;

/** The last index whose value is not above `value`; -1 before the first. Values ascend. */
function lastUpTo(values: number[], value: number): number {
  let [low, high] = [0, values.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((values[middle] ?? Infinity) <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** A flight at a moment, between the rows of its track; undefined before it begins and after it has ended. */
export function momentOf(flight: Flight, at_ms: number): Moment | undefined {
  const { track } = flight;
  const time_s = secondsOf(flight, at_ms);
  const i = lastUpTo(track.time_s, time_s);
  const j = Math.min(i + 1, track.time_s.length - 1);
  const [start, end] = [track.time_s[i], track.time_s[j]];
  const [mode, heading_deg] = [track.mode[i], track.heading_deg[i]];
  if (start === undefined || end === undefined || mode === undefined || heading_deg === undefined) return undefined;
  if (j === i && time_s > end) return undefined;
  const share = end > start ? (time_s - start) / (end - start) : 0;
  const between = (column: number[]): number => (column[i] ?? NaN) + share * ((column[j] ?? NaN) - (column[i] ?? NaN));
  const place = (lon: number[], lat: number[]): Position => {
    const [from, to]: [Position, Position] = [[lon[i] ?? NaN, lat[i] ?? NaN], [lon[j] ?? NaN, lat[j] ?? NaN]];
    const leg = inverse(from, to);
    return leg.distance_m === 0 ? from : destination(from, leg.azimuth_deg, share * leg.distance_m);
  };
  return {
    place: place(track.lon, track.lat),
    believed: place(track.believed_lon, track.believed_lat),
    sigma_m: between(track.sigma_m),
    depth_m: between(track.depth_m),
    heading_deg,
    mode,
    atSurface: track.at_surface[i] ?? false,
  };
}

const radians = Math.PI / 180;

/** How far a place lies from the planned route, positive to the right of it. */
export function crossTrackOf(route: Position[]): (place: Position) => number {
  const legs = route.slice(1).flatMap((to, i) => {
    const from = route[i];
    return from ? [{ from, ...inverse(from, to) }] : [];
  });
  return (place) => {
    let [least_m, signed_m] = [Infinity, 0];
    for (const leg of legs) {
      const seen = inverse(leg.from, place);
      const turn = (seen.azimuth_deg - leg.azimuth_deg) * radians;
      const across_m = seen.distance_m * Math.sin(turn);
      const along_m = seen.distance_m * Math.cos(turn);
      const beyond_m = along_m - Math.min(Math.max(along_m, 0), leg.distance_m);
      const distance_m = Math.hypot(across_m, beyond_m);
      if (distance_m >= least_m) continue;
      least_m = distance_m;
      signed_m = across_m < 0 ? -distance_m : distance_m;
    }
    return signed_m;
  };
}

/** Cross-track error of each row of a flight's track. */
export function crossTrackErrors_m({ track }: Flight, plan: Plan): number[] {
  const crossTrack = crossTrackOf(routeOf(plan));
  return track.lon.map((lon, i) => crossTrack([lon, track.lat[i] ?? NaN]));
}

/** Rows of a track under one mode, from `first` to `last`. */
export interface Stretch {
  mode: FlightMode;
  first: number;
  last: number;
}

export function stretchesOf(modes: FlightMode[]): Stretch[] {
  const stretches: Stretch[] = [];
  for (const [i, mode] of modes.entries()) {
    const current = stretches.at(-1);
    if (current?.mode === mode) current.last = i;
    else stretches.push({ mode, first: i, last: i });
  }
  return stretches;
}

/** How long a ping is shown as the present one. Tracks have a row each minute by default. */
export const sonarShown_s = 120;

/** The last ping of the sonar, unless it is older than `window_s`. */
export function sonarAt(flight: Flight, at_ms: number, window_s: number): { nearest_m: number; returns: number } | undefined {
  const { time_s, nearest_m, returns } = flight.sensors.sonar;
  const now_s = secondsOf(flight, at_ms);
  const i = lastUpTo(time_s, now_s);
  const [seen_s, nearest, count] = [time_s[i], nearest_m[i], returns[i]];
  if (seen_s === undefined || nearest === undefined || count === undefined || now_s - seen_s > window_s) return undefined;
  return { nearest_m: nearest, returns: count };
}

/**
 * This number of returns in one ping, or more, is an echo. False alarms come in one of fifty pings by default; three of them fall into one ping once
 * in a million.
 */
const sure_returns = 3;
export const isEcho = (returns: number): boolean => returns >= sure_returns;

/** The nearest return of each ping. Echoes are kept apart from single returns, which may be false alarms. */
export function returnsOf({ sensors: { sonar } }: Flight): { echoes: (number | null)[]; lone: (number | null)[] } {
  const kept = (wanted: boolean): (number | null)[] => sonar.nearest_m.map((nearest_m, i) => (isEcho(sonar.returns[i] ?? 0) === wanted ? nearest_m : null));
  return { echoes: kept(true), lone: kept(false) };
}

export const modeTitles: Record<FlightMode, string> = {
  mission: 'on its mission', path: 'around an obstacle', reactive: 'evading', 'given up': 'given up',
};

/** How many flights of a simulation ended in this way. */
export const endedSo = ({ statistics }: Pick<SimulationSummary, 'statistics'>, end: FlightEnd): number => statistics.ends.find((one) => one.end === end)?.runs ?? 0;

export const endTitles: Record<FlightEnd, string> = {
  arrived: 'arrived', collided: 'collided', grounded: 'grounded', gave_up: 'aborted', time_up: 'took too long', battery: 'battery empty',
  left_data: 'left the data', stopped: 'stopped',
};
