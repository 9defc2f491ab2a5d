import type { Position } from '../../contract/data_types';
import type { Plan, Waypoint } from '../../contract/types';
import { none } from '../units';

/** Whether dives on the leg to a waypoint must turn below ice or icebergs; unknown for plans without ice data. */
export const isLegBelowIce = ({ leg_upper_turn_m }: Waypoint): boolean | undefined =>
  typeof leg_upper_turn_m === 'number' ? leg_upper_turn_m > 0 : undefined;

/** A part of a route that is all below ice, or all in open water. */
export interface Run {
  places: Position[];
  isBelowIce: boolean;
}

/**
 * Divides a route into runs below ice and runs in open water, as few as possible. Each begins where the one before ends. Plans of older servers have
 * no stretches: in them, whole legs are below ice.
 */
export function runsOf({ waypoints, surfacing }: Plan): Run[] {
  const runs: Run[] = [];
  const go = (from: Position, to: Position, isBelowIce: boolean): void => {
    const last = runs.at(-1);
    if (last?.isBelowIce === isBelowIce) last.places.push(to);
    else runs.push({ places: [from, to], isBelowIce });
  };
  const stretches = surfacing?.below_ice;
  waypoints.slice(1).forEach((waypoint, i) => {
    const before = waypoints[i];
    if (!before) return;
    const goal: Position = [waypoint.lon, waypoint.lat];
    let here: Position = [before.lon, before.lat];
    for (const { from, to } of stretches?.filter((stretch) => stretch.waypoint === waypoint.index && stretch.distance_m > 0) ?? []) {
      if (!isSame(here, from)) go(here, from, false);
      go(from, to, true);
      here = to;
    }
    if (!isSame(here, goal)) go(here, goal, !stretches && (isLegBelowIce(waypoint) ?? false));
  });
  return runs;
}

const isSame = ([lon, lat]: Position, [otherLon, otherLat]: Position): boolean => lon === otherLon && lat === otherLat;

/** Length of the route below ice or icebergs; null where nothing is known of it. */
export const belowIce_m = ({ surfacing }: Plan): number | null => surfacing?.below_ice_m ?? null;
/** Time below ice or icebergs, in seconds; null where nothing is known of it. */
export const belowIce_s = ({ surfacing }: Plan): number | null => surfacing?.below_ice_s ?? null;

/** The number of waypoints where the vehicle may not surface; null if nothing is known about ice. */
export function closedWaypoints({ waypoints }: Plan): number | null {
  const known = waypoints.filter(({ may_surface }) => typeof may_surface === 'boolean');
  return known.length === 0 ? null : known.filter(({ may_surface }) => may_surface === false).length;
}

/**
 * The depth below which dives must turn on the leg with the deepest ice; null if nothing is known about ice, and 0 in
 * open water.
 */
export function deepestTurn_m({ waypoints }: Plan): number | null {
  const turns_m = waypoints.flatMap(({ leg_upper_turn_m }) => (typeof leg_upper_turn_m === 'number' ? [leg_upper_turn_m] : []));
  return turns_m.length === 0 ? null : Math.max(...turns_m);
}

/** The depth of an upper turn, rounded up to whole metres, as in the mission files and the brief. */
export const turnFigure = (turn_m: number | null | undefined): string => (typeof turn_m === 'number' ? String(Math.ceil(turn_m)) : none);

/** The text for a table cell: yes, no, or the dash if nothing is known about ice. */
export const maySurface = ({ may_surface }: Waypoint): string => (may_surface === true ? 'yes' : may_surface === false ? 'no' : none);
