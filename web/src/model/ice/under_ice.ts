import type { Position } from '../../contract/data_types';
import type { Plan, Waypoint } from '../../contract/types';
import { none } from '../units';

/** Whether dives on the leg to a waypoint must turn below ice or icebergs; unknown for plans without ice data. */
export const isLegBelowIce = ({ leg_upper_turn_m }: Waypoint): boolean | undefined =>
  typeof leg_upper_turn_m === 'number' ? leg_upper_turn_m > 0 : undefined;

/** Consecutive legs that are all below ice, or all in open water. */
export interface Run {
  places: Position[];
  isBelowIce: boolean;
}

/** Divides a route into runs of legs below ice and runs of other legs, as few as possible. Each begins where the one before ends. */
export function runsOf({ waypoints }: Plan): Run[] {
  const runs: Run[] = [];
  waypoints.slice(1).forEach((to, i) => {
    const from = waypoints[i];
    if (!from) return;
    const isBelowIce = isLegBelowIce(to) ?? false;
    const last = runs.at(-1);
    if (last?.isBelowIce === isBelowIce) last.places.push([to.lon, to.lat]);
    else runs.push({ places: [[from.lon, from.lat], [to.lon, to.lat]], isBelowIce });
  });
  return runs;
}

/** Length of the legs that have ice above them somewhere; null where nothing is known of ice. */
export function belowIce_m({ surfacing, waypoints }: Plan): number | null {
  if (!surfacing || waypoints.slice(1).some((waypoint) => isLegBelowIce(waypoint) === undefined)) return null;
  return waypoints.reduce((sum, waypoint) => sum + (isLegBelowIce(waypoint) ? (waypoint.leg_m ?? 0) : 0), 0);
}

/** At how many waypoints the vehicle may not surface; null where nothing is known of ice. */
export function closedWaypoints({ waypoints }: Plan): number | null {
  const known = waypoints.filter(({ may_surface }) => typeof may_surface === 'boolean');
  return known.length === 0 ? null : known.filter(({ may_surface }) => may_surface === false).length;
}

/** How deep the dives of the leg with the deepest ice must turn; null where nothing is known of ice, and 0 in open water. */
export function deepestTurn_m({ waypoints }: Plan): number | null {
  const turns_m = waypoints.flatMap(({ leg_upper_turn_m }) => (typeof leg_upper_turn_m === 'number' ? [leg_upper_turn_m] : []));
  return turns_m.length === 0 ? null : Math.max(...turns_m);
}

/** How deep dives turn, rounded down the water, as in the mission files and the brief. */
export const turnFigure = (turn_m: number | null | undefined): string => (typeof turn_m === 'number' ? String(Math.ceil(turn_m)) : none);

/** In a cell of a table: yes, no, or the dash where nothing is known of ice. */
export const maySurface = ({ may_surface }: Waypoint): string => (may_surface === true ? 'yes' : may_surface === false ? 'no' : none);
