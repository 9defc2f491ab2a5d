import { now } from './now';
import type { LonLat } from './page';

interface Dropped {
  name: string;
  text: string;
}
interface Chosen {
  name: string;
  mimeType: string;
  buffer: Buffer;
}

const chosen = (name: string, text: string): Chosen => ({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(text) });

/** Two present sightings near a place, and one with an impossible latitude. */
export function bergFile([lon, lat]: LonLat): Dropped {
  const observed = new Date(now() - 3_600_000).toISOString();
  const berg = (id: string, place: LonLat): object => ({
    type: 'Feature', properties: { id, observed, length_m: 90 }, geometry: { type: 'Point', coordinates: place },
  });
  const features = [berg('today-1', [lon + 0.1, lat + 0.03]), berg('today-2', [lon - 0.1, lat - 0.03]), berg('today-3', [lon, 99])];
  return { name: 'sighted-today.geojson', text: JSON.stringify({ type: 'FeatureCollection', features }) };
}

/** Levels of which half are above zero and half below, in a format that states no sign and no reference system. */
export function signlessDepths(): Chosen {
  const head = ['ncols 20', 'nrows 20', 'xllcorner -52.6', 'yllcorner 68.9', 'cellsize 0.02', 'NODATA_value -9999'];
  const rows = Array.from({ length: 20 }, (_, j) => Array.from({ length: 20 }, (__, i) => ((i + j) % 2 ? -100 - i - j : 100 + i)).join(' '));
  return chosen('levels.asc', [...head, ...rows, ''].join('\n'));
}

/** A zone that does not say its rule. */
export function zoneFile(): Chosen {
  const ring = [[-52.5, 69], [-52.4, 69], [-52.4, 69.05], [-52.5, 69.05], [-52.5, 69]];
  const feature = { type: 'Feature', properties: { name: 'Closed' }, geometry: { type: 'Polygon', coordinates: [ring] } };
  return chosen('closed.geojson', JSON.stringify({ type: 'FeatureCollection', features: [feature] }));
}

/** Sightings of now, spread over a degree each way around a place. */
export function crowdOfBergs([lon, lat]: LonLat, count: number): Chosen {
  const observed = new Date(now() - 3_600_000).toISOString();
  const features = Array.from({ length: count }, (_, i) => ({
    type: 'Feature', properties: { id: `crowd-${i}`, observed, length_m: 20 + (i % 200) },
    geometry: { type: 'Point', coordinates: [lon + 0.9 * Math.cos(i), lat + 0.5 * Math.sin(1.7 * i)] },
  }));
  return chosen('crowd.geojson', JSON.stringify({ type: 'FeatureCollection', features }));
}

/** Places in their order, as a table. */
export function routeFile(name: string, places: LonLat[]): Chosen {
  return chosen(name, ['lat,lon', ...places.map(([lon, lat]) => `${lat},${lon}`), ''].join('\n'));
}

/** The log of a Slocum that went from one place to another in two hours of 2014: two fixes, and the current it met between. */
export function trackLog([[lon, lat], [lon2, lat2]]: [LonLat, LonLat]): Chosen {
  const written = (deg: number): string => {
    const whole = Math.trunc(deg);
    return (whole * 100 + (deg - whole) * 60).toFixed(4);
  };
  const fix = (time_s: number, at: LonLat, current: string): string =>
    [time_s, written(at[1]), written(at[0]), written(at[1]), written(at[0]), 0, 0, current].join(',');
  const start_s = Date.UTC(2014, 6, 24, 17) / 1000;
  const rows = [
    '# mission_name=FIXED.MI',
    'm_present_time,m_lat,m_lon,m_gps_lat,m_gps_lon,m_gps_status,m_depth,m_final_water_vx,m_final_water_vy',
    'timestamp,lat,lon,lat,lon,enum,m,m/s,m/s',
    fix(start_s, [lon, lat], ','),
    [start_s + 3600, written((lat + lat2) / 2), written((lon + lon2) / 2), '', '', '', 120, '', ''].join(','),
    fix(start_s + 7200, [lon2, lat2], '0.1,0'),
    '',
  ];
  return chosen('went_here_nav.csv', rows.join('\n'));
}

/** An ice chart of two polygons with egg codes, beside each other west and east of a meridian. */
export function iceChart(name: string, [lon, lat]: LonLat): Chosen {
  const half = (west: number, codes: Record<string, string>): object => ({
    type: 'Feature',
    properties: { POLY_TYPE: 'I', ...codes },
    geometry: { type: 'Polygon', coordinates: [[[west, lat - 0.2], [west + 0.6, lat - 0.2], [west + 0.6, lat + 0.2], [west, lat + 0.2], [west, lat - 0.2]]] },
  });
  const features = [
    half(lon - 0.6, { CT: '91', CA: '60', SA: '87', FA: '05', CB: '30', SB: '84', FB: '04' }), half(lon, { CT: '46', CA: '40', SA: '84', FA: '03' }),
  ];
  return chosen(name, JSON.stringify({ type: 'FeatureCollection', features }));
}
