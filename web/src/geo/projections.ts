import proj4 from 'proj4/lib/core';
import defs from 'proj4/lib/defs';
import Proj from 'proj4/lib/Proj';
import stere from 'proj4/lib/projections/stere';
import type { Position } from '../contract/data_types';

/** The projections a view may have. Coordinates are metres; `lon0_deg` is the meridian that points up the screen. */
export const projections = {
  'EPSG:3413': { title: '45° W up', lon0_deg: -45, polar: true, lat_ts_deg: 70 },
  'EPSG:3995': { title: '0° up', lon0_deg: 0, polar: true, lat_ts_deg: 71 },
  'EPSG:3996': { title: '0° up, IBCAO', lon0_deg: 0, polar: true, lat_ts_deg: 75 },
  'EPSG:3857': { title: 'Mercator', lon0_deg: 0, polar: false, lat_ts_deg: 0 },
} as const;

export type ProjectionCode = keyof typeof projections;

export const projectionCodes = Object.keys(projections) as ProjectionCode[];

Proj.projections.add(stere);
for (const [code, { lon0_deg, lat_ts_deg, polar }] of Object.entries(projections)) {
  if (polar) defs(code, `+proj=stere +lat_0=90 +lat_ts=${lat_ts_deg} +lon_0=${lon0_deg} +datum=WGS84 +units=m`);
}

interface Converter {
  forward(coordinate: number[]): number[];
  inverse(coordinate: number[]): number[];
}

const converters: Record<ProjectionCode, Converter> = {
  'EPSG:3413': proj4('WGS84', 'EPSG:3413'),
  'EPSG:3995': proj4('WGS84', 'EPSG:3995'),
  'EPSG:3996': proj4('WGS84', 'EPSG:3996'),
  'EPSG:3857': proj4('WGS84', 'EPSG:3857'),
};

/** Southern limit of polar views: further south, distances in the projection grow up to a billion metres. */
export const polarSouthLimit_deg = 35;

/** Latitude beyond which Web Mercator is infinite for practical purposes. */
export const mercatorNorthLimit_deg = 85;

const pair = (numbers: number[]): Position => [numbers[0] ?? NaN, numbers[1] ?? NaN];

/** Longitude and latitude in degrees to metres in the projection. */
export function project(code: ProjectionCode, lonLat: Position): Position {
  return pair(converters[code].forward([lonLat[0], lonLat[1]]));
}

/** Metres in the projection to longitude (-180 to 180) and latitude in degrees. */
export function unproject(code: ProjectionCode, metres: Position): Position {
  return pair(converters[code].inverse([metres[0], metres[1]]));
}

/** Direction of true north at a place, in radians counter-clockwise from the projection's x axis. */
export function northAngle(code: ProjectionCode, [lon, lat]: Position): number {
  const step_deg = 1e-4;
  const here = project(code, [lon, Math.min(lat, 90 - 2 * step_deg)]);
  const there = project(code, [lon, Math.min(lat, 90 - 2 * step_deg) + step_deg]);
  return Math.atan2(there[1] - here[1], there[0] - here[0]);
}

/** Projected metres per true metre at a place, along the meridian. */
export function scaleFactor(code: ProjectionCode, [lon, lat]: Position): number {
  const step_deg = 1e-3;
  const south = Math.min(lat, 90 - 2 * step_deg);
  const [x0, y0] = project(code, [lon, south]);
  const [x1, y1] = project(code, [lon, south + step_deg]);
  return Math.hypot(x1 - x0, y1 - y0) / (meridianDegree_m(south) * step_deg);
}

/** Length of one degree of latitude on WGS84. */
function meridianDegree_m(lat_deg: number): number {
  const phi = (lat_deg * Math.PI) / 180;
  return 111132.954 - 559.822 * Math.cos(2 * phi) + 1.175 * Math.cos(4 * phi);
}
