import { describe, expect, it } from 'vitest';
import { around, boxAround, clipSouth, contains, grown, intersection, width_deg } from '../../src/geo/boxes';

describe('boxes', () => {
  it('are found around places on both sides of the antimeridian', () => {
    expect(boxAround([[179, 70], [-178, 72]])).toEqual([179, 70, -178, 72]);
    expect(width_deg([179, 70, -178, 72])).toBe(3);
  });

  it('intersect across the antimeridian', () => {
    expect(intersection([170, 60, -170, 70], [-179, 65, -160, 80])).toEqual([-179, 65, -170, 70]);
    expect(intersection([-56, 67, -50, 70], [-180, -90, 180, 90])).toEqual([-56, 67, -50, 70]);
    expect(intersection([-56, 67, -50, 70], [10, 60, 20, 70])).toBeUndefined();
  });

  it('are put around two others the shorter way', () => {
    expect(around([170, 60, 175, 70], [-178, 65, -170, 80])).toEqual([170, 60, -170, 80]);
    expect(around([-178, 65, -170, 80], [170, 60, 175, 70])).toEqual([170, 60, -170, 80]);
    expect(around([-56, 67, -50, 70], [-53, 68, -53, 68])).toEqual([-56, 67, -50, 70]);
    expect(around([179, 70, -179, 71], [-180, 70, -179.5, 71])).toEqual([179, 70, -179, 71]);
    expect(around([-180, 60, 180, 61], [10, 59, 20, 60])).toEqual([-180, 59, 180, 61]);
  });

  it('contain what lies within', () => {
    expect(contains([170, 60, -170, 70], [179, 61, -179, 69])).toBe(true);
    expect(contains([170, 60, -170, 70], [160, 61, 175, 69])).toBe(false);
  });

  it('grow to the whole circle at most', () => {
    expect(grown([-10, 80, 190 - 360, 89], 1)).toEqual([-180, 71, 180, 90]);
  });

  it('lose the part of a ring that lies too far south', () => {
    const ring = clipSouth([[0, 30], [10, 30], [10, 50], [0, 50], [0, 30]], 40);
    expect(ring.every(([, lat]) => lat >= 40)).toBe(true);
    expect(ring[0]).toEqual(ring.at(-1));
    expect(clipSouth([[0, 0], [1, 0], [1, 1], [0, 0]], 40)).toEqual([]);
  });
});
