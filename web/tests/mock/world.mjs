// An invented sea for tests of the client: a strait between two coasts, a gyre, a tide and a dozen bergs.

export const box = [-56, 67.5, -50, 70.5];
export const start_ms = Date.UTC(2026, 10, 20, 0);
export const hours = 120;

export const isoOf = (ms) => new Date(ms).toISOString().replace(/\.\d+Z$/, 'Z');

const coastline_lon = (lat) => -51.2 + 0.35 * Math.sin(lat * 5) + 0.15 * Math.sin(lat * 17);
const island = { lon: -53.6, lat: 69.45, rx: 0.8, ry: 0.28 };
const islandRadius = (angle) => 1 + 0.12 * Math.sin(3 * angle) + 0.06 * Math.sin(7 * angle);

function toIsland(lon, lat) {
  const [x, y] = [(lon - island.lon) / island.rx, (lat - island.lat) / island.ry];
  return Math.hypot(x, y) / islandRadius(Math.atan2(y, x));
}

export const isLand = (lon, lat) => lon > coastline_lon(lat) || toIsland(lon, lat) < 1;

export function depthAt(lon, lat) {
  if (isLand(lon, lat)) return -50;
  const offshore = Math.min((coastline_lon(lat) - lon) * 180, (toIsland(lon, lat) - 1) * 260);
  const bank = 120 * Math.exp(-(((lon + 54.8) / 0.5) ** 2) - ((lat - 68.4) / 0.3) ** 2);
  return Math.max(4, offshore + 70 * Math.sin(lon * 4) * Math.cos(lat * 6) + 350 * Math.exp(-(((lat - 68.9) / 0.18) ** 2)) - bank);
}

export function currentAt(lon, lat, ms) {
  if (isLand(lon, lat)) return undefined;
  const tide = Math.sin((2 * Math.PI * (ms - start_ms)) / (12.42 * 3_600_000));
  const [x, y] = [(lon + 53.5) / 1.6, (lat - 68.7) / 0.7];
  const swirl = 0.45 * Math.exp(-(x * x + y * y));
  return [-swirl * y + 0.06 * tide, swirl * x + 0.18 + 0.08 * tide];
}

function ringOfMainland() {
  const ring = [];
  for (let lat = 66; lat <= 72; lat += 0.02) ring.push([coastline_lon(lat), lat]);
  for (let lat = 72; lat >= 66; lat -= 0.5) ring.push([-45, lat]);
  ring.push(ring[0]);
  return ring;
}

function ringOfIsland() {
  const ring = [];
  for (let angle = 0; angle < 2 * Math.PI; angle += 0.04) {
    const r = islandRadius(angle);
    ring.push([island.lon + island.rx * r * Math.cos(angle), island.lat + island.ry * r * Math.sin(angle)]);
  }
  ring.push(ring[0]);
  return ring;
}

export const coast = {
  type: 'FeatureCollection',
  features: [ringOfMainland(), ringOfIsland()].map((ring) => ({
    type: 'Feature',
    properties: {},
    geometry: { type: 'Polygon', coordinates: [ring.map(([lon, lat]) => [Number(lon.toFixed(4)), Number(lat.toFixed(4))])] },
  })),
};

const bergs = [
  ['D-01', -51.9, 69.15, 'very_large', 420, 300], ['D-02', -52.05, 69.02, 'large', null, 250], ['D-03', -52.3, 69.22, 'medium', null, null],
  ['D-04', -52.6, 69.1, 'large', 160, 400], ['D-05', -52.9, 68.95, 'small', null, null], ['D-06', -53.2, 69.08, 'medium', 90, 200],
  ['D-07', -53.6, 68.85, 'bergy_bit', null, null], ['D-08', -52.2, 68.8, 'growler', null, null], ['D-09', -54.2, 69.0, 'very_large', null, 500],
  ['D-10', -54.7, 68.7, 'small', null, 800], ['D-11', -55.1, 69.2, 'radar_target', null, 1000], ['D-12', -51.8, 68.55, 'medium', null, null],
];
const safe_m = { very_large: 300, large: 200, medium: 120, small: 60, bergy_bit: 15, growler: 5, radar_target: 300 };

export function icebergsAt(ms) {
  return bergs.flatMap(([id, lon, lat, size, length, uncertainty], i) => {
    const sightings = [start_ms - 30 * 3_600_000, start_ms + 10 * 3_600_000, start_ms + 34 * 3_600_000];
    const last = sightings.findLastIndex((time) => time <= ms && ms - time <= 3 * 86_400_000 && !(i % 5 === 4 && time > start_ms));
    if (last < 0) return [];
    return [{
      type: 'Feature', id: 1 + i * 3 + last,
      geometry: { type: 'Point', coordinates: [lon - 0.05 * last, lat + 0.02 * last] },
      properties: {
        berg_id: id, observed: isoOf(sightings[last]), size, length_m: length, safe_length_m: length ?? safe_m[size], draft_m: null,
        position_uncertainty_m: uncertainty, shape: 'TAB', method: 'SAT-HIGH', dataset_id: 'ds-ice',
      },
    }];
  });
}

const common = (id, name, bbox, times) => ({
  id, name, bbox, time_start: times?.[0] ?? null, time_end: times?.at(-1) ?? null, rows_accepted: 0, rows_refused: 0,
  warnings: ['Synthetic data, not for navigation.'], file_name: `${id}.nc`, file_size_bytes: 123456,
  sha256: 'ab12cd34'.repeat(8), ingested: isoOf(start_ms + 3_600_000), tool_version: '0.1.0',
});
const times = Array.from({ length: hours / 3 + 1 }, (_, i) => isoOf(start_ms + i * 3 * 3_600_000));

export const datasets = [
  { ...common('ds-ice', 'synthetic berg sightings', box, [isoOf(start_ms - 30 * 3_600_000), isoOf(start_ms + 34 * 3_600_000)]), kind: 'icebergs', variables: [], rows_accepted: 36, rows_refused: 2 },
  { ...common('ds-cur', 'synthetic strait currents', box, times), kind: 'currents', variables: ['u_m_s', 'v_m_s'], times },
  { ...common('ds-bat', 'synthetic strait depths', [-56.5, 67, -49.5, 71], null), kind: 'bathymetry', variables: ['depth_m'] },
  { ...common('ds-coa', 'synthetic strait coast', [-57, 66, -45, 72], null), kind: 'coastline', variables: [] },
];

export const vehicles = [
  { name: 'slocum-g3-200', title: 'Slocum G3, 200 m', speed_m_s: 0.35, dive_depth_m: 180, depth_rating_m: 200, minimum_working_depth_m: 20, max_waypoints_per_list: 8 },
  { name: 'slocum-g3-1000', title: 'Slocum G3, 1000 m', speed_m_s: 0.35, dive_depth_m: 900, depth_rating_m: 1000, minimum_working_depth_m: 40, max_waypoints_per_list: 8 },
];
