import type { Departure, Plan } from '../../contract/types';
import { duration } from '../time';

/**
 * How the plan's travel time differs from that of its departure on the curve; empty where both show the same. The curve shows routes
 * on the grid, before refinement. Refinement mostly shortens a route. A limit on the waypoints, or an objective other than time, can
 * also make the plan longer.
 */
export function afterCurve(plan: Pick<Plan, 'travel_time_s' | 'refinement'>, { travel_time_s }: Pick<Departure, 'travel_time_s'>): string {
  if (travel_time_s === null) return '';
  const planned = duration(plan.travel_time_s);
  if (planned === duration(travel_time_s)) return '';
  return plan.refinement && plan.travel_time_s < travel_time_s ? `refined to ${planned}` : `${planned} along its final waypoints`;
}
