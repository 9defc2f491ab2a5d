import { describe, expect, it } from 'vitest';
import { laneCount, lanesOf } from '../../src/model/plan/lanes';
import type { ShownPlan } from '../../src/model/plan/plans';
import { makePlan } from './make_plan';

const shownPlan = (id: string, departure: string, arrival: string, style = 0): ShownPlan => ({ plan: { ...makePlan(id, [[-52, 69], [-51, 69]]), departure, arrival }, letter: id, style });

describe('the bars of plans below the clock', () => {
  const day = (id: string, date: number): ShownPlan => shownPlan(id, `2026-11-${date}T00:00:00Z`, `2026-11-${date}T20:00:00Z`);

  it('share a lane where they do not overlap', () => {
    const { bars, left } = lanesOf([day('a', 20), day('b', 20), day('c', 21), day('d', 22)], undefined);

    expect(bars.map(({ shown, lane }) => [shown.plan.plan_id, lane])).toEqual([['a', 0], ['b', 1], ['c', 0], ['d', 0]]);
    expect(left).toEqual([]);
  });

  it('are as many as there is room for, the selected plan among them', () => {
    const plans = Array.from({ length: laneCount + 3 }, (_, i) => day(`p${i}`, 20));

    const { bars, left } = lanesOf(plans, `p${laneCount + 2}`);

    expect(bars).toHaveLength(laneCount);
    expect(bars[0]?.shown.plan.plan_id).toBe(`p${laneCount + 2}`);
    expect(left).toHaveLength(3);
  });
});
