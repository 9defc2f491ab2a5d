import type { Position } from '../contract/data_types';
import type { Plan, Waypoint } from '../contract/types';

/** Whether dives on the leg to a waypoint must turn below ice or icebergs; unknown for plans without ice data. */
export const isLegBelowIce = ({ leg_upper_turn_m }: Waypoint): boolean | undefined =>
  typeof leg_upper_turn_m === 'number' ? leg_upper_turn_m > 0 : undefined;

/** Consecutive legs that are all below ice, or all in open water. */
export interface Run {
  places: Position[];
  isBelowIce: boolean;
}

/** Divides a route into such runs, as few as possible. Each begins where the one before ends. */
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

/** In a cell of a table: yes, no, or the dash where nothing is known of ice. */
export const maySurface = ({ may_surface }: Waypoint): string => (may_surface === true ? 'yes' : may_surface === false ? 'no' : '–');
