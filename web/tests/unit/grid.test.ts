import { describe, expect, it } from 'vitest';
import { decodeGrid, sample, SampledPlaces, type Grid } from '../../src/geo/grid';

/** A grid as the server writes it. */
function encoded(header: Record<string, unknown>, words: number[]): ArrayBuffer {
  let text = JSON.stringify({ missing: -32768, time: null, dataset_id: 'd', dataset_name: 'd', warnings: [], ...header });
  while ((4 + text.length) % 8 !== 0) text += ' ';
  const bytes = new ArrayBuffer(4 + text.length + 2 * words.length);
  const view = new DataView(bytes);
  view.setUint32(0, text.length, true);
  new Uint8Array(bytes, 4, text.length).set(new TextEncoder().encode(text));
  words.forEach((word, i) => view.setInt16(4 + text.length + 2 * i, word, true));
  return bytes;
}

const frame = { nx: 2, ny: 2, west_deg: 10, south_deg: 60, dx_deg: 1, dy_deg: 1 };
const currents = { ...frame, variables: ['u_m_s', 'v_m_s'], scale: [0.001, 0.01] };

describe('binary grids', () => {
  it('are read variable by variable, south row first, with their scales', () => {
    const grid = decodeGrid(encoded(currents, [100, 200, 300, 400, -10, -20, -30, -40]));
    expect(sample(grid, 0, 10, 60)).toBeCloseTo(0.1);
    expect(sample(grid, 0, 11, 60)).toBeCloseTo(0.2);
    expect(sample(grid, 0, 10, 61)).toBeCloseTo(0.3);
    expect(sample(grid, 1, 11, 61)).toBeCloseTo(-0.4);
    expect(sample(grid, 0, 10.5, 60.5)).toBeCloseTo(0.25);
  });

  it('have no value outside or next to a missing corner, and one on a known corner', () => {
    const grid = decodeGrid(encoded({ ...frame, variables: ['depth_m'], scale: [1] }, [5, -32768, 7, 8]));
    expect(sample(grid, 0, 9.99, 60)).toBeNaN();
    expect(sample(grid, 0, 10.5, 62)).toBeNaN();
    expect(sample(grid, 0, 10.5, 60.5)).toBeNaN();
    expect(sample(grid, 0, 10, 60)).toBe(5);
  });

  it('reach across the antimeridian', () => {
    const grid = decodeGrid(encoded({ ...frame, west_deg: 179.5, variables: ['depth_m'], scale: [1] }, [1, 3, 1, 3]));
    expect(sample(grid, 0, 180, 60)).toBeCloseTo(2);
    expect(sample(grid, 0, -179.75, 60)).toBeCloseTo(2.5);
    expect(sample(grid, 0, -179, 60)).toBeNaN();
  });

  it('are refused when cut short', () => {
    const whole = encoded(currents, [1, 2, 3, 4, 5, 6, 7, 8]);
    expect(() => decodeGrid(whole.slice(0, whole.byteLength - 2))).toThrow(/cut short/);
    expect(() => decodeGrid(new ArrayBuffer(2))).toThrow(/cut short/);
  });

  it('are linear in time between two, at fixed places', () => {
    const [first, second, third] = [[0, 0, 0, 0], [100, 100, 100, -32768], [300, 300, 300, 300]].map((words) => decodeGrid(encoded({ ...frame, variables: ['u_m_s'], scale: [0.001] }, words)));
    if (!first || !second || !third) throw new Error('no grids');
    const places = new SampledPlaces(0, Float64Array.of(10, 10.8), Float64Array.of(60, 60.8));
    const at = (before: Grid, after: Grid, share: number): number[] => [...places.at({ before, after, share })].map((value) => Math.round(1000 * value));
    expect(at(first, second, 0)).toEqual([0, 0]);
    expect(at(first, second, 0.25)).toEqual([25, NaN]);
    expect(at(second, third, 0.25)).toEqual([150, NaN]);
    expect(at(first, third, 0.25)).toEqual([75, 75]);
  });
});
