import type { Position } from '../contract/data_types';

/**
 * Geodesics on WGS84 by Vincenty's formulae, exact to a millimetre over the distances of a mission. Almost antipodal points
 * do not converge; for them the great circle on the mean radius is used.
 * Source  Vincenty 1975, Survey Review 23(176): 88-93.
 */

const a = 6378137;
const f = 1 / 298.257223563;
const b = a * (1 - f);
const radians = Math.PI / 180;
const meanRadius_m = 6371008.8;

export interface Leg {
  distance_m: number;
  azimuth_deg: number; // at the first place, clockwise from true north, 0 to 360
}

function series(cosSqAlpha: number): { A: number; B: number } {
  const uSq = (cosSqAlpha * (a * a - b * b)) / (b * b);
  return {
    A: 1 + (uSq / 16384) * (4096 + uSq * (-768 + uSq * (320 - 175 * uSq))),
    B: (uSq / 1024) * (256 + uSq * (-128 + uSq * (74 - 47 * uSq))),
  };
}

function deltaSigma(B: number, sinSigma: number, cosSigma: number, cos2m: number): number {
  return (
    B * sinSigma *
    (cos2m + (B / 4) * (cosSigma * (2 * cos2m ** 2 - 1) - (B / 6) * cos2m * (4 * sinSigma ** 2 - 3) * (4 * cos2m ** 2 - 3)))
  );
}

/** The end of the geodesic of length `distance_m` that leaves `from` at `azimuth_deg`. */
export function destination(from: Position, azimuth_deg: number, distance_m: number): Position {
  const alpha1 = azimuth_deg * radians;
  const tanU1 = (1 - f) * Math.tan(from[1] * radians);
  const cosU1 = 1 / Math.sqrt(1 + tanU1 * tanU1);
  const sinU1 = tanU1 * cosU1;
  const sigma1 = Math.atan2(tanU1, Math.cos(alpha1));
  const sinAlpha = cosU1 * Math.sin(alpha1);
  const cosSqAlpha = 1 - sinAlpha * sinAlpha;
  const { A, B } = series(cosSqAlpha);

  let sigma = distance_m / (b * A);
  for (let i = 0; i < 100; ++i) {
    const cos2m = Math.cos(2 * sigma1 + sigma);
    const next = distance_m / (b * A) + deltaSigma(B, Math.sin(sigma), Math.cos(sigma), cos2m);
    const step = Math.abs(next - sigma);
    sigma = next;
    if (step < 1e-12) break;
  }
  const sinSigma = Math.sin(sigma);
  const cosSigma = Math.cos(sigma);
  const cos2m = Math.cos(2 * sigma1 + sigma);

  const across = sinU1 * sinSigma - cosU1 * cosSigma * Math.cos(alpha1);
  const lat = Math.atan2(
    sinU1 * cosSigma + cosU1 * sinSigma * Math.cos(alpha1),
    (1 - f) * Math.sqrt(sinAlpha ** 2 + across ** 2),
  );
  const lambda = Math.atan2(sinSigma * Math.sin(alpha1), cosU1 * cosSigma - sinU1 * sinSigma * Math.cos(alpha1));
  const C = (f / 16) * cosSqAlpha * (4 + f * (4 - 3 * cosSqAlpha));
  const L =
    lambda - (1 - C) * f * sinAlpha * (sigma + C * sinSigma * (cos2m + C * cosSigma * (2 * cos2m ** 2 - 1)));
  return [wrapLongitude(from[0] + L / radians), lat / radians];
}

/** Length and first azimuth of the geodesic between two places. */
export function inverse(from: Position, to: Position): Leg {
  const L = wrapLongitude(to[0] - from[0]) * radians;
  const U1 = Math.atan((1 - f) * Math.tan(from[1] * radians));
  const U2 = Math.atan((1 - f) * Math.tan(to[1] * radians));
  const [sinU1, cosU1, sinU2, cosU2] = [Math.sin(U1), Math.cos(U1), Math.sin(U2), Math.cos(U2)];

  let lambda = L;
  for (let i = 0; i < 200; ++i) {
    const sinLambda = Math.sin(lambda);
    const cosLambda = Math.cos(lambda);
    const sinSigma = Math.hypot(cosU2 * sinLambda, cosU1 * sinU2 - sinU1 * cosU2 * cosLambda);
    if (sinSigma === 0) return { distance_m: 0, azimuth_deg: 0 };
    const cosSigma = sinU1 * sinU2 + cosU1 * cosU2 * cosLambda;
    const sigma = Math.atan2(sinSigma, cosSigma);
    const sinAlpha = (cosU1 * cosU2 * sinLambda) / sinSigma;
    const cosSqAlpha = 1 - sinAlpha * sinAlpha;
    const cos2m = cosSqAlpha === 0 ? 0 : cosSigma - (2 * sinU1 * sinU2) / cosSqAlpha;
    const C = (f / 16) * cosSqAlpha * (4 + f * (4 - 3 * cosSqAlpha));
    const next =
      L + (1 - C) * f * sinAlpha * (sigma + C * sinSigma * (cos2m + C * cosSigma * (2 * cos2m ** 2 - 1)));
    const step = Math.abs(next - lambda);
    lambda = next;
    if (step > 1e-12) continue;

    const { A, B } = series(cosSqAlpha);
    const azimuth = Math.atan2(cosU2 * Math.sin(lambda), cosU1 * sinU2 - sinU1 * cosU2 * Math.cos(lambda));
    return {
      distance_m: b * A * (sigma - deltaSigma(B, sinSigma, cosSigma, cos2m)),
      azimuth_deg: (azimuth / radians + 360) % 360,
    };
  }
  return greatCircle(from, to);
}

function greatCircle(from: Position, to: Position): Leg {
  const [phi1, phi2] = [from[1] * radians, to[1] * radians];
  const dLambda = (to[0] - from[0]) * radians;
  const cosine = Math.sin(phi1) * Math.sin(phi2) + Math.cos(phi1) * Math.cos(phi2) * Math.cos(dLambda);
  const azimuth = Math.atan2(
    Math.sin(dLambda) * Math.cos(phi2),
    Math.cos(phi1) * Math.sin(phi2) - Math.sin(phi1) * Math.cos(phi2) * Math.cos(dLambda),
  );
  return { distance_m: meanRadius_m * Math.acos(Math.max(-1, Math.min(1, cosine))), azimuth_deg: (azimuth / radians + 360) % 360 };
}

/** Closed ring of places at `radius_m` from `centre`. */
export function circle(centre: Position, radius_m: number, sides = 64): Position[] {
  const ring: Position[] = [];
  for (let i = 0; i < sides; ++i) ring.push(destination(centre, (360 * i) / sides, radius_m));
  const first = ring[0];
  if (first) ring.push(first);
  return ring;
}

/** The line with points added along each geodesic, so that no piece is longer than `step_m`. */
export function densify(line: Position[], step_m: number): Position[] {
  const result: Position[] = [];
  line.forEach((place, i) => {
    const before = line[i - 1];
    if (before) {
      const leg = inverse(before, place);
      const pieces = Math.min(200, Math.ceil(leg.distance_m / step_m));
      for (let k = 1; k < pieces; ++k) result.push(destination(before, leg.azimuth_deg, (leg.distance_m * k) / pieces));
    }
    result.push(place);
  });
  return result;
}

/** Longitude brought into -180 to 180. */
export function wrapLongitude(lon_deg: number): number {
  if (lon_deg >= -180 && lon_deg <= 180) return lon_deg;
  return ((((lon_deg + 180) % 360) + 360) % 360) - 180;
}
