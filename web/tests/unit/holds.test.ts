import { describe, expect, it } from 'vitest';
import { allHolds_s, holdsOf } from '../../src/model/plan/holds';
import { makePlan } from './make_plan';

const plan = makePlan('one', [[-52, 69], [-51.5, 69], [-51, 69.1], [-50.5, 69.1]]);
const holding = { ...plan, waypoints: plan.waypoints.map((waypoint) => ({ ...waypoint, wait_s: [600, 0, 9600, 0][waypoint.index] ?? 0 })) };

describe('the holds of a plan', () => {
  it('are told by waypoint, the start among them', () => {
    expect(holdsOf(holding)).toEqual(['hold 10 min at waypoint S', 'hold 2 h 40 min at waypoint 2']);
    expect(allHolds_s(holding)).toBe(10_200);
  });

  it('are none in plans of servers that knew none', () => {
    expect(holdsOf(plan)).toEqual([]);
    expect(allHolds_s(plan)).toBe(0);
  });
});
