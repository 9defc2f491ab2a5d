import { describe, expect, it } from 'vitest';
import type { Position } from '../../src/contract/data_types';
import { northAngle, project, projectionCodes, projections, scaleFactor, unproject } from '../../src/geo/projections';
import { directionTowards_deg, rotateToView } from '../../src/geo/vectors';

const arctic: Position[] = [[-50, 69.1], [-51.35, 69.17], [-53, 47.5], [10, 79], [179.9, 72], [-179.9, 72], [0, 60], [95, 81.5]];

describe('projections', () => {
  it.each([
    ['EPSG:3413', -199453.257, -2279761.159],
    ['EPSG:3995', -1758330.789, -1475414.717],
    ['EPSG:3996', -1776763.746, -1490881.804],
  ] as const)('puts 50 W 69.1 N where the reference has it in %s', (code, x, y) => {
    const [px, py] = project(code, [-50, 69.1]);
    expect(px).toBeCloseTo(x, 2);
    expect(py).toBeCloseTo(y, 2);
  });

  it.each(projectionCodes)('comes back to the same place through %s', (code) => {
    for (const place of arctic) {
      const [lon, lat] = unproject(code, project(code, place));
      expect(lon).toBeCloseTo(place[0], 8);
      expect(lat).toBeCloseTo(place[1], 8);
    }
  });

  it.each(projectionCodes)('turns a northward current along the north arrow in %s', (code) => {
    for (const place of arctic) {
      const [x, y] = rotateToView(code, place, 0, 0.4);
      expect(Math.hypot(x, y)).toBeCloseTo(0.4, 9);
      expect(Math.cos(Math.atan2(y, x) - northAngle(code, place))).toBeCloseTo(1, 9);
      const there = project(code, [place[0], place[1] + 0.01]);
      const here = project(code, place);
      expect(Math.cos(Math.atan2(y, x) - Math.atan2(there[1] - here[1], there[0] - here[0]))).toBeCloseTo(1, 6);
    }
  });

  it.each(projectionCodes)('turns an eastward current towards a place to the east in %s', (code) => {
    for (const place of arctic) {
      const [x, y] = rotateToView(code, place, 1, 0);
      const [here, there] = [project(code, place), project(code, [place[0] - 0.001, place[1]])];
      expect(Math.cos(Math.atan2(y, x) - Math.atan2(here[1] - there[1], here[0] - there[0]))).toBeCloseTo(1, 4);
    }
  });

  it('draws its own meridian straight up in the polar projections', () => {
    for (const code of projectionCodes) {
      if (!projections[code].polar) continue;
      expect(northAngle(code, [projections[code].lon0_deg, 70])).toBeCloseTo(Math.PI / 2, 6);
    }
  });

  it('is true to scale at its standard parallel, and stretched by 2.8 at 69 N in Mercator', () => {
    expect(scaleFactor('EPSG:3413', [-50, 70])).toBeCloseTo(1, 3);
    expect(scaleFactor('EPSG:3857', [-50, 69])).toBeCloseTo(2.79, 1);
  });

  it('gives directions clockwise from north', () => {
    expect(directionTowards_deg(0, 1)).toBe(0);
    expect(directionTowards_deg(1, 0)).toBe(90);
    expect(directionTowards_deg(-1, 0)).toBe(270);
  });
});
