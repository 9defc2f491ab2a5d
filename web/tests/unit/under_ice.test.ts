import { describe, expect, it } from 'vitest';
import type { Plan, StretchBelowIce, Surfacing } from '../../src/contract/types';
import { belowIce_m, belowIce_s, closedWaypoints, deepestTurn_m, isLegBelowIce, maySurface, runsOf, turnFigure } from '../../src/model/ice/under_ice';
import { makePlan } from './make_plan';

const surfacing: Surfacing = { longest_without_surfacing_s: 3600, unknown_ice_m: 0, planned: [], escapes: [] };

function planBelow(turns: (number | null)[], known: Surfacing | null = surfacing): Plan {
  const plan = makePlan('p', turns.map((_, i) => [-53 + i, 69]));
  const waypoints = plan.waypoints.map((waypoint, i) => ({ ...waypoint, leg_m: i === 0 ? null : 1000 * i, leg_upper_turn_m: turns[i] ?? null }));
  return { ...plan, waypoints, surfacing: known };
}

describe('a plan below ice', () => {
  const shapeOf = (plan: Plan): unknown => runsOf(plan).map(({ isBelowIce, places }) => [isBelowIce, places.map(([lon]) => lon)]);
  const stretch = (waypoint: number, from: number, to: number): StretchBelowIce => ({
    waypoint, from: [from, 69], to: [to, 69], enters: '2026-11-22T06:00:00Z', time_s: 60, distance_m: 1000 * (to - from),
  });

  it('is in runs below ice and in open water that end within legs', () => {
    const below_ice = [stretch(1, -52.8, -52.6), stretch(2, -51.25, -51), stretch(3, -51, -50), stretch(4, -50, -49.5)];
    const plan = planBelow([null, 17, 17, 21, 4], { ...surfacing, below_ice, below_ice_m: 1950, below_ice_s: 240 });

    expect(shapeOf(plan)).toEqual([
      [false, [-53, -52.8]], [true, [-52.8, -52.6]], [false, [-52.6, -52, -51.25]], [true, [-51.25, -51, -50, -49.5]], [false, [-49.5, -49]],
    ]);
    expect(belowIce_m(plan)).toBe(1950);
    expect(belowIce_s(plan)).toBe(240);
  });

  it('has whole legs below ice, of unknown length, where an older server made it', () => {
    const plan = planBelow([null, 0, 17, 21, 0]);

    expect(shapeOf(plan)).toEqual([[false, [-53, -52]], [true, [-52, -51, -50]], [false, [-50, -49]]]);
    expect(belowIce_m(plan)).toBeNull();
  });

  it('tells where it may not surface, and the deepest turn of its legs', () => {
    const plan = planBelow([null, 0, 17, 21, 0]);
    const waypoints = plan.waypoints.map((waypoint, i) => ({ ...waypoint, may_surface: i < 2 || i > 3 }));

    expect(closedWaypoints({ ...plan, waypoints })).toBe(2);
    expect(deepestTurn_m(plan)).toBe(21);
    expect(turnFigure(21.06)).toBe('22');
    expect(deepestTurn_m(planBelow([null, 0, 0]))).toBe(0);
  });

  it('says nothing of ice that nobody knows', () => {
    expect(closedWaypoints(planBelow([null, null]))).toBeNull();
    expect(deepestTurn_m(planBelow([null, null]))).toBeNull();
    expect(belowIce_m(planBelow([null, 0, 0], null))).toBeNull();
    expect(belowIce_m(planBelow([null, null]))).toBeNull();
    const [, unknown] = planBelow([null, null]).waypoints;
    expect(unknown && isLegBelowIce(unknown)).toBeUndefined();
    expect(unknown && maySurface(unknown)).toBe('–');
    expect(unknown && maySurface({ ...unknown, may_surface: false })).toBe('no');
    expect(unknown && maySurface({ ...unknown, may_surface: true })).toBe('yes');
  });
});
