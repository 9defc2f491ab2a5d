// A stand-in for the Floeplan server: the paths, documents and headers of its contract over the invented sea of world.mjs.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';
import * as world from './world.mjs';
import { makePlan } from './plans.mjs';

const csp = "default-src 'self'; img-src 'self' data: blob:; style-src 'self'; object-src 'none'; base-uri 'none'; frame-ancestors 'none'";
const types = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };

/** Starts the server on a free port of the loopback interface; `empty` leaves its store without data. */
export async function startMock({ dist, port = 0, empty = false, job_ms = 1500 }) {
  const store = { jobs: new Map(), plans: new Map(), datasets: empty ? [] : world.datasets, job_ms, next: 1 };
  const server = createServer((request, response) => {
    answer(store, dist, request)
      .then((reply) => send(request, response, reply))
      .catch((error) => send(request, response, problem(500, 'internal', String(error.stack))));
  });
  await new Promise((resolve) => server.listen(port, '127.0.0.1', resolve));
  return { url: `http://127.0.0.1:${server.address().port}`, close: () => new Promise((resolve) => server.close(resolve)) };
}

function send(request, response, { status = 200, type = 'application/json', body, headers = {} }) {
  const bytes = Buffer.isBuffer(body) ? body : Buffer.from(typeof body === 'string' ? body : JSON.stringify(body ?? ''));
  const all = { 'Content-Type': type, 'X-Content-Type-Options': 'nosniff', ...headers };
  if (type.startsWith('text/html')) all['Content-Security-Policy'] = csp;
  const zip = bytes.length > 1024 && /gzip/.test(request.headers['accept-encoding'] ?? '');
  if (zip) all['Content-Encoding'] = 'gzip';
  response.writeHead(status, all);
  response.end(status === 204 ? undefined : zip ? gzipSync(bytes) : bytes);
}

const problem = (status, slug, detail, errors) => ({
  status,
  type: 'application/problem+json',
  body: { type: `/problems/${slug}`, title: slug.replaceAll('-', ' '), status, detail, ...(errors ? { errors } : {}) },
});

async function answer(store, dist, request) {
  const url = new URL(request.url, 'http://mock');
  const path = decodeURIComponent(url.pathname);
  if (path === '/') return asset(dist, 'index.html', {});
  if (path.startsWith('/app/')) return asset(dist, path.slice(5), { 'Cache-Control': 'max-age=31536000, immutable' });
  if (path === '/datasets') return { body: { datasets: store.datasets } };
  if (path === '/session') return { body: { name: 'local', role: 'admin' } };
  if (path === '/vehicles') return { body: { vehicles: world.vehicles } };
  if (path === '/map/coast') return { type: 'application/geo+json', body: store.datasets.length > 0 ? world.coast : { type: 'FeatureCollection', features: [] } };
  if (path === '/map/bathymetry') return grid(url, ['depth_m'], [1], (lon, lat) => [world.depthAt(lon, lat)], null, 'ds-bat');
  if (path === '/map/currents') return currents(url);
  if (path === '/probe') return { body: probe(url) };
  if (path === '/collections/icebergs/items') return icebergs(url);
  if (path.startsWith('/collections/plans/items')) return plans(store, request, url, path.split('/').slice(4));
  if (path === '/processes/plan-route/execution' && request.method === 'POST') return execute(store, request);
  if (path.startsWith('/jobs/')) return job(store, request, path.split('/').slice(2));
  return problem(404, 'not-found', `Nothing is at ${path}.`);
}

async function asset(dist, name, headers) {
  try {
    const body = await readFile(join(dist, normalize(name).replace(/^(\.\.[/\\])+/, '')));
    return { type: types[extname(name)] ?? 'application/octet-stream', body, headers };
  } catch {
    return problem(404, 'not-found', `No asset is called ${name}.`);
  }
}

function grid(url, variables, scale, at, time, dataset) {
  const [west, south, eastRaw, north] = url.searchParams.get('bbox').split(',').map(Number);
  const east = eastRaw < west ? eastRaw + 360 : eastRaw;
  const [nx, ny] = [Number(url.searchParams.get('nx')), Number(url.searchParams.get('ny'))];
  if (!(nx >= 2 && nx <= 1024 && ny >= 2 && ny <= 1024)) return problem(400, 'invalid-request', 'nx and ny must lie between 2 and 1024.');
  const [dx, dy] = [(east - west) / (nx - 1), (north - south) / (ny - 1)];
  let header = JSON.stringify({
    variables, scale, missing: -32768, nx, ny, west_deg: west, south_deg: south, dx_deg: dx, dy_deg: dy, time,
    dataset_id: dataset, dataset_name: dataset, warnings: [],
  });
  while ((4 + Buffer.byteLength(header)) % 8 !== 0) header += ' ';
  const head = Buffer.from(header);
  const body = Buffer.alloc(4 + head.length + 2 * nx * ny * variables.length);
  body.writeUInt32LE(head.length, 0);
  head.copy(body, 4);
  for (let j = 0; j < ny; ++j) {
    for (let i = 0; i < nx; ++i) {
      const values = at(west + i * dx, south + j * dy);
      variables.forEach((_, k) => {
        const value = values ? Math.round(values[k] / scale[k]) : -32768;
        body.writeInt16LE(value, 4 + head.length + 2 * (k * nx * ny + j * nx + i));
      });
    }
  }
  return { type: 'application/octet-stream', body };
}

function currents(url) {
  const ms = Date.parse(url.searchParams.get('time'));
  if (!(ms >= world.start_ms && ms <= world.start_ms + world.hours * 3_600_000)) {
    return problem(404, 'no-data', 'No currents are stored for this time.');
  }
  const at = (lon, lat) => world.currentAt(lon, lat, ms);
  return grid(url, ['u_m_s', 'v_m_s'], [0.001, 0.001], at, url.searchParams.get('time'), 'ds-cur');
}

function probe(url) {
  const [lon, lat] = [Number(url.searchParams.get('lon')), Number(url.searchParams.get('lat'))];
  const time = url.searchParams.get('time');
  const velocity = world.currentAt(lon, lat, Date.parse(time));
  const near = world.icebergsAt(Date.parse(time)).map(({ geometry, properties }) => ({
    berg_id: properties.berg_id, observed: properties.observed, size: properties.size,
    distance_m: 111_000 * Math.hypot((geometry.coordinates[0] - lon) * 0.36, geometry.coordinates[1] - lat),
  }));
  return {
    lon, lat, time, depth_m: world.depthAt(lon, lat), depth_reason: null, land: world.isLand(lon, lat),
    currents: {
      u_m_s: velocity?.[0] ?? null, v_m_s: velocity?.[1] ?? null, reason: velocity ? null : 'on land', dataset_id: 'ds-cur',
      dataset_name: 'synthetic strait currents', time_before: time, time_after: time,
    },
    ice_concentration: null, ice_concentration_reason: 'no sea ice data are stored',
    water_level: { height_m: null, datum: null, station: null, dataset_name: null, time_before: null, time_after: null },
    icebergs_within: near.sort((a, b) => a.distance_m - b.distance_m).slice(0, 3),
  };
}

function icebergs(url) {
  const known = new Set(['bbox', 'datetime', 'limit', 'after', 'dataset', 'latest']);
  for (const key of url.searchParams.keys()) if (!known.has(key)) return problem(400, 'invalid-request', `Unknown parameter ${key}.`);
  const features = world.icebergsAt(Date.parse(url.searchParams.get('datetime')));
  return { type: 'application/geo+json', body: { type: 'FeatureCollection', features, numberMatched: features.length, numberReturned: features.length, links: [] } };
}

function plans(store, request, url, [id, what]) {
  if (!id) {
    const features = [...store.plans.values()].map(featureOf);
    return { type: 'application/geo+json', body: { type: 'FeatureCollection', features, numberMatched: features.length, numberReturned: features.length, links: [] } };
  }
  const plan = store.plans.get(id);
  if (!plan) return problem(404, 'unknown-feature', 'No plan has this id.');
  if (request.method === 'DELETE') {
    store.plans.delete(id);
    return { status: 204 };
  }
  const number = String(url.searchParams.get('number') ?? '10').padStart(2, '0');
  const name = `goto_l${number}.ma`;
  const text = [
    `behavior_name=goto_list`, `# ${plan.name || plan.plan_id}: ${plan.waypoints.length} waypoints`, '<start:b_arg>',
    `    b_arg: num_waypoints(nodim) ${plan.waypoints.length}`, '<end:b_arg>', '<start:waypoints>',
    ...plan.waypoints.map(({ lon, lat }) => `${packed(lon)} ${packed(lat)}`), '<end:waypoints>', '',
  ].join('\n');
  if (what === 'mission') return { body: { files: [{ name, text }], warnings: ['Check the list against the master data before it flies.'] } };
  if (what?.startsWith('mission.')) {
    return { type: 'application/octet-stream', body: text, headers: { 'Content-Disposition': `attachment; filename="plan.${what.slice(8)}"` } };
  }
  return { type: 'application/geo+json', body: featureOf(plan) };
}

const packed = (degrees) => {
  const whole = Math.trunc(degrees);
  return (whole * 100 + (degrees - whole) * 60).toFixed(4);
};

const featureOf = (plan) => ({
  type: 'Feature', id: plan.plan_id, properties: plan,
  geometry: { type: 'LineString', coordinates: plan.waypoints.map(({ lon, lat }) => [lon, lat]) },
});

async function execute(store, request) {
  let text = '';
  for await (const chunk of request) text += chunk;
  const { inputs } = JSON.parse(text);
  const errors = [];
  if (!(inputs.margin_m >= 0)) errors.push({ pointer: '/inputs/margin_m', detail: 'must lie between 0 and 100000' });
  if (inputs.speed_m_s !== undefined && !(inputs.speed_m_s >= 0.05 && inputs.speed_m_s <= 5)) {
    errors.push({ pointer: '/inputs/speed_m_s', detail: 'must lie between 0.05 and 5' });
  }
  if (errors.length > 0) return problem(400, 'invalid-request', 'The request has faults; each is listed.', errors);
  const id = `job-${store.next++}`;
  store.jobs.set(id, { id, inputs, created: Date.now(), dismissed: false });
  return { status: 201, headers: { Location: `/jobs/${id}` }, body: statusOf(store, store.jobs.get(id)) };
}

function statusOf(store, job) {
  const share = Math.min(1, (Date.now() - job.created) / store.job_ms);
  const done = share >= 1;
  const status = job.dismissed ? 'dismissed' : done ? 'successful' : share < 0.1 ? 'accepted' : 'running';
  const progress = done ? 100 : Math.floor(share * 20) * 5;
  return {
    jobID: job.id, type: 'process', processID: 'plan-route', status, message: '', progress,
    stage: share < 0.25 ? 'loading data' : share < 0.8 ? 'search' : 'refinement', created: world.isoOf(job.created), updated: world.isoOf(Date.now()), links: [],
  };
}

async function job(store, request, [id, what]) {
  const found = store.jobs.get(id);
  if (!found) return problem(404, 'unknown-job', 'No job has this id.');
  if (request.method === 'DELETE') found.dismissed = true;
  if (what === 'results') {
    if (statusOf(store, found).status !== 'successful') return problem(404, 'result-not-ready', 'The job is not done.');
    found.plan ??= makePlan(found.inputs, `${found.id}-plan`);
    if (found.plan.status === 'ok') store.plans.set(found.plan.plan_id, found.plan);
    return { body: { plan: found.plan } };
  }
  const wait_s = Number(/wait=(\d+)/.exec(request.headers['prefer'] ?? '')?.[1] ?? 0);
  const before = statusOf(store, found);
  const until = Date.now() + 1000 * wait_s;
  while (Date.now() < until && statusOf(store, found).progress === before.progress && before.status !== 'successful') {
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  return { body: statusOf(store, found) };
}
