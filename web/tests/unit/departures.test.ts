import { describe, expect, it } from 'vitest';
import { afterCurve } from '../../src/model/plan/departures';

const refinement = { before_s: 36_000, after_s: 35_000, evaluations: 1, stopped_by: 'converged' } as const;

describe("a plan beside its departure's way on the curve", () => {
  it('says that refinement made it shorter', () => {
    expect(afterCurve({ travel_time_s: 35_400, refinement }, { travel_time_s: 36_000 })).toBe('refined to 9 h 50 min');
  });

  it('does not call a longer time a refinement', () => {
    expect(afterCurve({ travel_time_s: 36_600, refinement }, { travel_time_s: 36_000 })).toBe('10 h 10 min along its final waypoints');
  });

  it('does not speak of refinement where there was none', () => {
    expect(afterCurve({ travel_time_s: 35_400, refinement: null }, { travel_time_s: 36_000 })).toBe('9 h 50 min along its final waypoints');
  });

  it('says nothing where both times read the same, or no way was found', () => {
    expect(afterCurve({ travel_time_s: 36_001, refinement }, { travel_time_s: 36_000 })).toBe('');
    expect(afterCurve({ travel_time_s: 36_000, refinement }, { travel_time_s: null })).toBe('');
  });
});
