import type { Departure, Plan } from '../api/types';
import { duration } from './time';

/**
 * What the plan made of its departure's way, or nothing where both show the same time. The curve has each way as the grid gives it.
 * Refinement mostly shortens it; a limit on the waypoints, or an objective other than time, can also make the plan the longer one.
 */
export function afterCurve(plan: Pick<Plan, 'travel_time_s' | 'refinement'>, { travel_time_s }: Pick<Departure, 'travel_time_s'>): string {
  if (travel_time_s === null) return '';
  const planned = duration(plan.travel_time_s);
  if (planned === duration(travel_time_s)) return '';
  return plan.refinement && plan.travel_time_s < travel_time_s ? `refined to ${planned}` : `${planned} along its final waypoints`;
}
