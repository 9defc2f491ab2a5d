import { describe, expect, it } from 'vitest';
import { withMoreLegs } from '../../src/model/plan/leg_trade';
import { makePlan } from './make_plan';

describe('what more legs would gain', () => {
  const twoHours = makePlan('one', [[-52, 69], [-51.5, 69], [-51, 69.1]]);
  const plan = (leg_trade: { legs: number; travel_time_s: number }[]) => ({ ...twoHours, leg_trade });

  it('is that of the fastest route', () => {
    const trade = [
      { legs: 2, travel_time_s: 7200 },
      { legs: 8, travel_time_s: 6600 },
      { legs: 16, travel_time_s: 6900 },
    ];
    expect(withMoreLegs(plan(trade))).toEqual({ legs: 8, gain_s: 600 });
  });

  it('is not told if it is nothing, or if the plan was not refined', () => {
    expect(withMoreLegs(plan([{ legs: 8, travel_time_s: 7190 }]))).toBeNull();
    expect(withMoreLegs(plan([]))).toBeNull();
    expect(withMoreLegs(twoHours)).toBeNull();
  });
});
