import type { Plan } from '../../contract/types';

const least_s = 30; // a gain below half a minute would be shown as none

/** What more legs would gain: the fastest of the refined routes beside the plan. Null: less than half a minute. */
export function withMoreLegs({ leg_trade = [], travel_time_s }: Plan): { legs: number; gain_s: number } | null {
  const fastest = leg_trade.reduce((best, each) => (each.travel_time_s < best.travel_time_s ? each : best), { legs: 0, travel_time_s });
  const gain_s = travel_time_s - fastest.travel_time_s;
  return gain_s >= least_s ? { legs: fastest.legs, gain_s } : null;
}
