import type { Box, Position } from '../contract/data_types';
import { wrapLongitude } from './geodesic';

/** Boxes extend eastwards from their west: a box across the antimeridian has a west greater than its east. */

/** Width of a box in degrees, 0 to 360. */
export function width_deg([west, , east]: Box): number {
  return east >= west ? east - west : east - west + 360;
}

/** The smallest box around places close together; longitudes are taken relative to the first. */
export function boxAround(places: Position[]): Box | undefined {
  const first = places[0];
  if (!first) return undefined;
  let [west, south, east, north] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [lon, lat] of places) {
    const near = first[0] + wrapLongitude(lon - first[0]);
    west = Math.min(west, near);
    east = Math.max(east, near);
    south = Math.min(south, lat);
    north = Math.max(north, lat);
  }
  if (east - west >= 360) return [-180, south, 180, north];
  return [wrapLongitude(west), south, wrapLongitude(east), north];
}

/**
 * The common part of two boxes; undefined if there is none. If there are two parts, the one closer to the west of `a`.
 */
export function intersection(a: Box, b: Box): Box | undefined {
  const south = Math.max(a[1], b[1]);
  const north = Math.min(a[3], b[3]);
  if (south >= north) return undefined;
  if (width_deg(b) >= 360) return [a[0], south, a[2], north];
  if (width_deg(a) >= 360) return [b[0], south, b[2], north];
  for (const turn of [-360, 0, 360]) {
    const west = Math.max(a[0], b[0] + turn);
    const east = Math.min(a[0] + width_deg(a), b[0] + turn + width_deg(b));
    if (west < east) return [wrapLongitude(west), south, wrapLongitude(east), north];
  }
  return undefined;
}

/** The smallest box around both, across the antimeridian where that is nearer. */
export function around(a: Box, b: Box): Box {
  const [south, north] = [Math.min(a[1], b[1]), Math.max(a[3], b[3])];
  const from = (first: Box, second: Box): number => {
    const offset = (((second[0] - first[0]) % 360) + 360) % 360;
    return Math.max(width_deg(first), offset + width_deg(second));
  };
  const [widthA, widthB] = [from(a, b), from(b, a)];
  if (Math.min(widthA, widthB) >= 360) return [-180, south, 180, north];
  const [west, width] = widthA <= widthB ? [a[0], widthA] : [b[0], widthB];
  return [west, south, wrapLongitude(west + width), north];
}

export function contains(outer: Box, inner: Box): boolean {
  if (inner[1] < outer[1] || inner[3] > outer[3]) return false;
  if (width_deg(outer) >= 360) return true;
  const offset = ((inner[0] - outer[0]) % 360 + 360) % 360;
  return offset + width_deg(inner) <= width_deg(outer) + 1e-9;
}

/** The box grown on every side by a share of its size, within the world. */
export function grown(box: Box, share: number): Box {
  const width = width_deg(box);
  const dLat = (box[3] - box[1]) * share;
  const south = Math.max(-90, box[1] - dLat);
  const north = Math.min(90, box[3] + dLat);
  if (width * (1 + 2 * share) >= 360) return [-180, south, 180, north];
  return [wrapLongitude(box[0] - width * share), south, wrapLongitude(box[0] + width * (1 + share)), north];
}

/**
 * The border of a box as a closed ring along its parallels and meridians, with a place at least every half degree of
 * longitude.
 */
export function borderOf(box: Box): Position[] {
  const [west, south, , north] = box;
  const pieces = Math.max(4, Math.ceil(width_deg(box) / 0.5));
  const along = (lat: number): Position[] =>
    Array.from({ length: pieces + 1 }, (_, i) => [wrapLongitude(west + (width_deg(box) * i) / pieces), lat]);
  const southern = along(south);
  return [...southern, ...along(north).reverse(), southern[0] ?? [west, south]];
}

export function centreOf(box: Box): Position {
  return [wrapLongitude(box[0] + width_deg(box) / 2), (box[1] + box[3]) / 2];
}

/** The box for an address, rounded to four decimals (11 m), so that the cache finds it again. */
export function rounded(box: Box): Box {
  return box.map((value) => Math.round(value * 1e4) / 1e4) as Box;
}

/** The part of a ring north of a latitude (Sutherland-Hodgman against one edge); empty when nothing is left. */
export function clipSouth(ring: Position[], south_deg: number): Position[] {
  if (ring.every(([, lat]) => lat >= south_deg)) return ring;
  const result: Position[] = [];
  for (let i = 0; i + 1 < ring.length; ++i) {
    const [from, to] = [ring[i], ring[i + 1]];
    if (!from || !to) continue;
    const inside = from[1] >= south_deg;
    if (inside) result.push(from);
    if (inside !== to[1] >= south_deg) {
      const share = (south_deg - from[1]) / (to[1] - from[1]);
      result.push([from[0] + share * (to[0] - from[0]), south_deg]);
    }
  }
  const first = result[0];
  if (result.length < 3 || !first) return [];
  return [...result, first];
}
