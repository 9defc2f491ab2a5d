import { describe, expect, it } from 'vitest';
import type { IcebergDrift } from '../../src/contract/data_types';
import { driftLineOf, expectedAt, plainLineOf, ticksOf } from '../../src/model/ice/drift';

const start_ms = Date.parse('2026-11-20T06:00:00Z');
const hour_ms = 3_600_000;
const hours = Array.from({ length: 14 }, (_, i) => i);
const drift: IcebergDrift = {
  berg_id: 'B', observed: '2026-11-20T06:00:00Z', safe_length_m: 100, time: hours.map((hour) => new Date(start_ms + hour * hour_ms).toISOString()),
  lon: hours.map((hour) => -52 + 0.01 * hour), lat: hours.map(() => 69), error_m: hours.map((hour) => 200 + 750 * hour),
};

describe('where a berg is expected', () => {
  it('is between its fixes, within an error that has grown till then', () => {
    const expected = expectedAt(drift, start_ms + 2.5 * hour_ms);
    expect(expected?.place[0]).toBeCloseTo(-51.975, 6);
    expect(expected?.error_m).toBeCloseTo(2075, 6);
    expect(expectedAt(drift, start_ms)?.error_m).toBe(200);
  });

  it('is not said before the sighting nor after the forecast', () => {
    expect(expectedAt(drift, start_ms - 1)).toBeUndefined();
    expect(expectedAt(drift, start_ms + 13 * hour_ms)).toBeDefined();
    expect(expectedAt(drift, start_ms + 13 * hour_ms + 1)).toBeUndefined();
  });

  it('is ticked off every six hours', () => {
    expect(ticksOf(drift).map(([lon]) => Number(lon.toFixed(4)))).toEqual([-51.94, -51.88]);
  });

  it('is drawn from afar without the swing of the tide, from the same beginning to the same end', () => {
    const swinging = { ...drift, lat: hours.map((hour) => 69 + 0.01 * Math.sin((2 * Math.PI * hour) / 12.42)) };
    const [line, plain] = [driftLineOf(swinging), plainLineOf(swinging)];
    expect([plain[0], plain.at(-1)]).toEqual([line[0], line.at(-1)]);
    expect(plain).toHaveLength(3);
    expect(plain[1]?.[1]).toBeCloseTo(69, 3);
  });
});
