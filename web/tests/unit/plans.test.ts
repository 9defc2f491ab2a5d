import { beforeEach, describe, expect, it } from 'vitest';
import type { Plan } from '../../src/contract/types';
import { inverse } from '../../src/geo/geodesic';
import { hueOf, planDash } from '../../src/theme/palette';
import { setSpan, setTime, time_ms } from '../../src/model/clock';
import { redo, undo } from '../../src/model/undo';
import { add, forget, nextName, plans, select, selectedPlan, show, shown, shownPlans, vehicleAt } from '../../src/model/plan/plans';

function plan(id: string, name = ''): Plan {
  const waypoint = (index: number, lon: number, lat: number, eta: string): Plan['waypoints'][number] => ({
    index, lon, lat, eta, leg_m: null, course_deg: null, speed_over_ground_m_s: null, depth_m: null,
  });
  return {
    plan_id: id, name, status: 'ok', method: 'astar', vehicle: 'v', departure: '2026-11-20T00:00:00Z', arrival: '2026-11-20T10:00:00Z',
    travel_time_s: 36_000, distance_m: 1, energy_j: null, optimality_gap: null, optimality_gap_reason: '',
    waypoints: [waypoint(0, -52, 69, '2026-11-20T00:00:00Z'), waypoint(1, -52, 69.1, '2026-11-20T04:00:00Z'), waypoint(2, -51, 69.1, '2026-11-20T10:00:00Z')],
    search: { vertices: 0, edges: 0, edge_evaluations: 0, expansions: 0, reinsertions: 0, fifo_violations: 0, worst_fifo_violation: null, seconds: 0 },
    clearances: { iceberg_m: null, land_m: null, bottom_m: null }, datasets: [], warnings: [],
  };
}

describe('plans', () => {
  beforeEach(() => {
    plans.value = [];
    shown.value = [];
    select(undefined);
  });

  it('get letters in the order in which they are shown', () => {
    add(plan('one'));
    add(plan('two'));
    expect(shownPlans.value.map(({ letter, plan: { plan_id } }) => `${letter} ${plan_id}`)).toEqual(['A one', 'B two']);
    expect(selectedPlan.value?.plan_id).toBe('two');
    show('two', false);
    expect(selectedPlan.value?.plan_id).toBe('one');
  });

  it('leave the map when planning them is undone, and stay in the list', () => {
    setSpan('a day', { start_ms: 0, end_ms: 86_400_000 });
    add(plan('before'));
    setTime(7_200_000);
    add(plan('new', 'Plan 2'), [plan('alternative')]);
    setTime(3_600_000);
    expect(undo()?.title).toBe('planning Plan 2, which stays in the list');
    expect([shown.value, selectedPlan.value?.plan_id, time_ms.value]).toEqual([['before'], 'before', 7_200_000]);
    expect(plans.value).toHaveLength(3);
    redo();
    expect([shown.value, selectedPlan.value?.plan_id, time_ms.value]).toEqual([['before', 'new', 'alternative'], 'new', 3_600_000]);
    forget('before');
    undo();
    expect([shown.value, selectedPlan.value]).toEqual([[], undefined]);
    setSpan('a day', undefined);
  });

  it('keep their letter and colour as long as they are listed, and those with the same colour differ in dash', () => {
    for (const id of ['one', 'two', 'three']) add(plan(id));
    const keyOf = (id: string): string | undefined => {
      const found = shownPlans.value.find((candidate) => candidate.plan.plan_id === id);
      return found && `${found.letter}${found.style}`;
    };
    const [second, third] = [keyOf('two'), keyOf('three')];
    show('one', false);
    expect([keyOf('two'), keyOf('three')]).toEqual([second, third]);
    add(plan('four'));
    show('one', true);
    expect(new Set(['one', 'two', 'three', 'four'].map(keyOf)).size).toBe(4);
    expect(keyOf('one')).toBe('A0');
    forget('two');
    expect([keyOf('one'), keyOf('three'), keyOf('four')]).toEqual(['A0', third, 'D3']);
    expect(second).toBe('B1');
    add(plan('five'));
    expect(keyOf('five')).toBe(second);

    const looks = Array.from({ length: 20 }, (_, style) => `${hueOf(style)} ${planDash(style).join()}`);
    expect(new Set(looks).size).toBe(20);
    expect(new Set(Array.from({ length: 10 }, (_, style) => hueOf(style))).size).toBe(10);
  });

  it('take the letter of a plan that is not on the map where all letters are in use', () => {
    for (let i = 0; i < 26; ++i) add(plan(`p${i}`));
    expect(shownPlans.value).toHaveLength(26);
    show('p3', false);
    add(plan('one more'));
    expect(shownPlans.value.find(({ plan: { plan_id } }) => plan_id === 'one more')?.letter).toBe('D');
    expect(new Set(shownPlans.value.map(({ letter }) => letter)).size).toBe(26);
  });

  it('are named by the next free number', () => {
    add(plan('one', 'Plan 4'));
    add(plan('two', 'ice camp'));
    expect(nextName()).toBe('Plan 5');
  });

  it('have their vehicle on the leg under way, and nowhere outside the mission', () => {
    const half = vehicleAt(plan('one'), Date.parse('2026-11-20T02:00:00Z'));
    expect(half?.leg).toBe(1);
    expect(half?.course_deg).toBeCloseTo(0, 6);
    const leg = inverse([-52, 69], [-52, 69.1]);
    expect(inverse([-52, 69], half?.place ?? [0, 0]).distance_m).toBeCloseTo(leg.distance_m / 2, 2);
    expect(vehicleAt(plan('one'), Date.parse('2026-11-19T23:00:00Z'))).toBeUndefined();
    expect(vehicleAt(plan('one'), Date.parse('2026-11-20T10:00:01Z'))).toBeUndefined();
  });
});
