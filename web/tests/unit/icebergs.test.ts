import { beforeEach, describe, expect, it } from 'vitest';
import type { IcebergProperties } from '../../src/contract/data_types';
import { edit } from '../../src/model/setup/draft';
import { keepOut_m, lookOf, strengthOf } from '../../src/model/ice/icebergs';

describe('the distance kept from a berg', () => {
  beforeEach(() => edit({ margin_m: '500', max_inflation_m: '' }));

  it('is hull, margin and the error of its position, up to a bound', () => {
    expect(keepOut_m(200, 1200)).toBe(100 + 500 + 1200);
    expect(keepOut_m(200, 90_000)).toBe(100 + 500 + 5000);
    edit({ margin_m: '50', max_inflation_m: '800' });
    expect(keepOut_m(200, 1200)).toBe(100 + 50 + 800);
  });

  it('takes the usual values where the set-up says nothing that can be read', () => {
    edit({ margin_m: 'far', max_inflation_m: '-3' });
    expect(keepOut_m(0, 90_000)).toBe(500 + 5000);
  });
});

describe('a sighting', () => {
  const seen = '2026-11-20T06:00:00Z';
  const strengthAfter = (hours: number, limit_days = 3): number =>
    strengthOf({ observed: seen } as IcebergProperties, Date.parse(seen) + hours * 3_600_000, limit_days);

  it('is drawn paler the older it is, down to the age at which it no longer counts', () => {
    expect(strengthAfter(-1)).toBe(1);
    expect(strengthAfter(0)).toBe(1);
    expect(strengthAfter(36)).toBeCloseTo(0.675, 6);
    expect(strengthAfter(72)).toBeCloseTo(0.35, 6);
    expect(strengthAfter(500)).toBeCloseTo(0.35, 6);
    expect(strengthAfter(72, 6)).toBeCloseTo(0.675, 6);
  });

  it('looks the same in most hours, and hardly other than its age says', () => {
    const berg = { observed: seen } as IcebergProperties;
    const hours = Array.from({ length: 100 }, (_, hour) => Date.parse(seen) + hour * 3_600_000);
    const looks = hours.map((at_ms) => lookOf(berg, at_ms, 3));

    expect(new Set(looks.map((look) => JSON.stringify(look))).size).toBeLessThanOrEqual(16);
    looks.forEach(({ strength, stale }, hour) => {
      expect(Math.abs(strength - strengthOf(berg, hours[hour] ?? NaN, 3))).toBeLessThanOrEqual(0.0251);
      expect(stale).toBe(hour > 24);
    });
  });

  it('is seen also where no age is allowed', () => expect(strengthAfter(1, 0)).toBeGreaterThan(0.3));
});
