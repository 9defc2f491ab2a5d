import type { Plan, Waypoint } from '../../contract/types';
import { waypointLabel } from './plans';
import { duration } from '../time';

/** The duration of the hold at a waypoint before its next leg; 0: no hold. */
export const hold_s = ({ wait_s }: Waypoint): number => wait_s ?? 0;

/** "hold 2 h 40 min" */
export const holdText = (waypoint: Waypoint): string => `hold ${duration(hold_s(waypoint))}`;

/** "hold 2 h 40 min at waypoint 4", for each, in their order. */
export const holdsOf = ({ waypoints }: Plan): string[] =>
  waypoints.filter((waypoint) => hold_s(waypoint) > 0).map((waypoint) => `${holdText(waypoint)} at waypoint ${waypointLabel(waypoint.index)}`);

/** The sum of all holds of a plan. */
export const allHolds_s = ({ waypoints }: Plan): number => waypoints.reduce((sum, waypoint) => sum + hold_s(waypoint), 0);
