import { describe, expect, it } from 'vitest';
import type { Position } from '../../src/contract/data_types';
import { circle, densify, destination, inverse, wrapLongitude } from '../../src/geo/geodesic';

describe('geodesics', () => {
  it('agree with the published length of the line from Flinders Peak to Buninyong', () => {
    // Geoscience Australia's test line; GRS80 and WGS84 differ by less than a millimetre here.
    const leg = inverse([144.42486789, -37.95103342], [143.92649553, -37.65282114]);
    expect(leg.distance_m).toBeCloseTo(54972.271, 2);
    expect(leg.azimuth_deg).toBeCloseTo(306.86816, 4);
  });

  it('come back: the way out and the way measured are the same', () => {
    const from: Position = [-52.3, 69.1];
    for (const azimuth of [0, 37, 90, 181, 270, 359]) {
      const leg = inverse(from, destination(from, azimuth, 43_210));
      expect(leg.distance_m).toBeCloseTo(43_210, 3);
      expect(Math.cos(((leg.azimuth_deg - azimuth) * Math.PI) / 180)).toBeCloseTo(1, 9);
    }
  });

  it.each([[-52, 69], [-53, 47.5], [179.99, 75], [12, 86]] as Position[])('keep a circle at its radius around %d %d', (lon, lat) => {
    for (const place of circle([lon, lat], 1500)) expect(inverse([lon, lat], place).distance_m).toBeCloseTo(1500, 3);
  });

  it('close the ring of a circle', () => {
    const ring = circle([-52, 69], 800, 32);
    expect(ring).toHaveLength(33);
    expect(ring[0]).toEqual(ring[32]);
  });

  it('leave no piece of a densified line longer than asked, and keep its corners', () => {
    const line: Position[] = [[-55, 68], [-50, 70], [-45, 69]];
    const dense = densify(line, 5000);
    for (const corner of line) expect(dense).toContainEqual(corner);
    dense.slice(1).forEach((place, i) => expect(inverse(dense[i] ?? place, place).distance_m).toBeLessThan(5001));
  });

  it('bring longitudes into range', () => {
    expect(wrapLongitude(190)).toBe(-170);
    expect(wrapLongitude(-190)).toBe(170);
    expect(wrapLongitude(180)).toBe(180);
  });
});
