import type { Box, CoastFeature, FeaturePage, GliderTrackFeature, IceChart, IcebergDrift, IcebergFeature, IcebergTrackFeature, IngestInputs, IngestReport, NewFeature, Position, StoredDatasets, Upload, Vehicle, ZoneFeature } from '../contract/data_types';
import type { EvaluateInputs, EvaluationResults, JobStatus, MissionPreview, PlanFeature, PlanInputs, PlanResults, Probe, Reach, ReachInputs } from '../contract/types';
import type { Flight, SimulateInputs, Simulation, SimulationSummary } from '../contract/simulation_types';
import { decodeGrid, type Grid } from '../geo/grid';
import type { IcebergChoice } from '../model/setup/iceberg_choice';
import type { Caller } from '../model/login';
import { pairs, type ExportQuery } from '../model/plan/export_options';
import { address, ApiError, dangersIn, faultsOf, json, noteRefusal, request, silence, wordsOf } from './http';

export { ApiError, dangersIn, faultsOf, wordsOf };

async function grid(path: string, signal?: AbortSignal): Promise<Grid> {
  return decodeGrid(await (await request(path, { signal: signal ?? null })).arrayBuffer());
}

export const whoAmI = (): Promise<Caller> => json('/session');

/** Signs in. The server answers with a cookie that scripts cannot read; the token itself is not stored. */
export const logIn = (token: string): Promise<Caller> =>
  json('/session', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ token }) });

export const logOut = async (): Promise<void> => {
  await request('/session', { method: 'DELETE' });
};

export const datasets = (): Promise<StoredDatasets> => json('/datasets');
export const vehicles = (): Promise<{ vehicles: Vehicle[] }> => json('/vehicles');

export const bathymetry = (box: Box, nx: number, ny: number, dataset: string, signal: AbortSignal): Promise<Grid> =>
  grid(address('/map/bathymetry', { bbox: box.join(','), nx, ny, dataset }), signal);

export const currents = (
  box: Box, nx: number, ny: number, time: string, dataset: string,
): Promise<Grid> => grid(address('/map/currents', { bbox: box.join(','), nx, ny, time, dataset }));

export const seaIce = (box: Box, nx: number, ny: number, time: string, dataset: string): Promise<Grid> =>
  grid(address('/map/sea-ice', { bbox: box.join(','), nx, ny, time, dataset }));

export const coast = (box: Box, signal: AbortSignal): Promise<{ features: CoastFeature[] }> =>
  json(address('/map/coast', { bbox: box.join(',') }), { signal });

/** `columns`: resolution of the picture; corners closer together than a column are merged. */
export const iceChart = (box: Box, columns: number, dataset: string, signal: AbortSignal): Promise<IceChart> =>
  json(address('/map/ice-chart', { bbox: box.join(','), nx: columns, dataset }), { signal });

const choiceOf = ({ datasets, max_sighting_age_days, departure }: IcebergChoice): Record<string, string | number | undefined> => ({
  dataset: datasets?.join(','), max_sighting_age_days, departure,
});

export const icebergsAt = (time: string, choice: IcebergChoice, signal: AbortSignal): Promise<FeaturePage<IcebergFeature>> =>
  json(address('/collections/icebergs/items', { latest: true, datetime: time, limit: 10000, ...choiceOf(choice) }), { signal });

export const icebergsOf = (dataset: string): Promise<FeaturePage<IcebergFeature>> =>
  json(address('/collections/icebergs/items', { dataset, limit: 10000 }));

export const icebergTracks = (berg_id: string, signal: AbortSignal): Promise<FeaturePage<IcebergTrackFeature>> =>
  json(address('/collections/iceberg-tracks/items', { berg_id, limit: 1 }), { signal });

export const gliderTracks = (signal: AbortSignal): Promise<FeaturePage<GliderTrackFeature>> =>
  json(address('/collections/glider-tracks/items', { limit: 1000 }), { signal });

export const zones = (): Promise<FeaturePage<ZoneFeature>> => json(address('/collections/nogo-zones/items', { limit: 10000 }));

interface Tagged {
  id: string;
  tag: string | undefined; // entity tag of its present state, sent with the next change
}

const collections = { icebergs: 'icebergs', zones: 'nogo-zones' };
const itemsOf = (kind: keyof typeof collections): string => `/collections/${collections[kind]}/items`;
const tagOf = (response: Response): string | undefined => response.headers.get('etag') ?? undefined;
const ifStill = (tag: string | undefined): Record<string, string> => (tag === undefined ? {} : { 'If-Match': tag });

/** The present state of a feature, with its entity tag. */
export async function feature(kind: keyof typeof collections, id: number | string): Promise<{ feature: IcebergFeature | ZoneFeature; tag: string | undefined }> {
  const response = await request(`${itemsOf(kind)}/${encodeURIComponent(id)}`, { headers: { Accept: 'application/geo+json' }, cache: 'no-store' });
  return { feature: (await response.json()) as IcebergFeature | ZoneFeature, tag: tagOf(response) };
}

export async function createFeature(kind: keyof typeof collections, stated: NewFeature): Promise<Tagged> {
  const response = await request(itemsOf(kind), { method: 'POST', headers: { 'Content-Type': 'application/geo+json' }, body: JSON.stringify(stated) });
  return { id: response.headers.get('location')?.split('/').at(-1) ?? '', tag: tagOf(response) };
}

export async function replaceFeature(kind: keyof typeof collections, id: string, stated: NewFeature, tag: string | undefined): Promise<Tagged> {
  const headers = { 'Content-Type': 'application/geo+json', ...ifStill(tag) };
  const response = await request(`${itemsOf(kind)}/${encodeURIComponent(id)}`, { method: 'PUT', headers, body: JSON.stringify(stated) });
  return { id, tag: tagOf(response) };
}

export const removeFeature = async (kind: keyof typeof collections, id: string, tag: string | undefined): Promise<void> => {
  await request(`${itemsOf(kind)}/${encodeURIComponent(id)}`, { method: 'DELETE', headers: ifStill(tag) });
};

interface DriftQuery {
  box: Box;
  as_of: string;
  until: string;
  choice: IcebergChoice;
  currents: string | undefined; // undefined: the currents that a plan would use
}

export const drift = ({ box, choice, ...query }: DriftQuery, signal: AbortSignal): Promise<{ bergs: IcebergDrift[]; numberMatched: number }> =>
  json(address('/map/drift', { bbox: box.join(','), ...query, ...choiceOf(choice) }), { signal });

/** All stored plans. The server lists the oldest first, but the newest matter most, so all pages are read. */
export async function plans(): Promise<PlanFeature[]> {
  const all: PlanFeature[] = [];
  let after: string | undefined;
  do {
    const page = await json<FeaturePage<PlanFeature>>(address('/collections/plans/items', { limit: 500, after }));
    all.push(...page.features);
    const next = page.links.find(({ rel }) => rel === 'next');
    after = next && (new URL(next.href, location.href).searchParams.get('after') ?? undefined);
  } while (after !== undefined);
  return all;
}

export const plan = (planId: string): Promise<PlanFeature> => json(`/collections/plans/items/${encodeURIComponent(planId)}`);

/** The inputs that a plan was made with, whoever made it. */
export const planInputs = (planId: string): Promise<PlanInputs> => json(`/collections/plans/items/${encodeURIComponent(planId)}/inputs`);

export const deletePlan = async (planId: string): Promise<void> => {
  // completes even if the page is left
  await request(`/collections/plans/items/${encodeURIComponent(planId)}`, { method: 'DELETE', keepalive: true });
};

/** `accept`: the pilot has confirmed the plan's dangers; without it the server refuses files of a plan with dangers. */
export const mission = (planId: string, query: ExportQuery, accept: boolean): Promise<MissionPreview> =>
  json(address(`/collections/plans/items/${encodeURIComponent(planId)}/mission`, { ...query, ...accepted(accept) }));

const accepted = (accept: boolean): { accept_dangers?: boolean } => (accept ? { accept_dangers: true } : {});

export type ExportFormat = 'zip' | 'gpx' | 'kml' | 'geojson' | 'csv' | 'nmea' | 'imc' | 'targets' | 'html' | 'pdf';

/** The address from which the browser downloads a plan; only the archive of mission files uses `query`. */
export const downloadAddress = (planId: string, format: ExportFormat, query: ExportQuery, accept: boolean): string =>
  address(`/collections/plans/items/${encodeURIComponent(planId)}/mission.${format}`, { ...(format === 'zip' ? query : {}), ...accepted(accept) });

/** The page to print; `safe`: the safe places of the export, which the page lists. */
export const briefAddress = (planId: string, safe: Position[]): string =>
  address(`/collections/plans/items/${encodeURIComponent(planId)}/mission.html`, { safe: safe.length > 0 ? pairs(safe) : undefined });

/** Probes the place, rounded to a decimetre. For a kind with chosen datasets, only these are used. */
export const probe = ([lon, lat]: Position, time: string, choice: Partial<IcebergChoice>): Promise<Probe> => {
  const { dataset, ...ages } = choiceOf({ datasets: undefined, max_sighting_age_days: undefined, departure: undefined, ...choice });
  return json(address('/probe', { lon: Number(lon.toFixed(6)), lat: Number(lat.toFixed(6)), time, ...ages, dataset: dataset === '' ? undefined : dataset }));
};

/** Submits work to a process; the answer is the job. */
const submit = (process: string, inputs: object): Promise<JobStatus> =>
  json(`/processes/${process}/execution`, {
    method: 'POST',
    headers: { 'Content-Type': 'application/json', Prefer: 'respond-async' },
    body: JSON.stringify({ inputs }),
  });

export const submitPlan = (inputs: PlanInputs): Promise<JobStatus> => submit('plan-route', inputs);
export const submitIngest = (inputs: IngestInputs): Promise<JobStatus> => submit('ingest', inputs);
export const submitSimulation = (inputs: SimulateInputs): Promise<JobStatus> => submit('simulate-plan', inputs);

export const ingestReport = (jobId: string): Promise<{ report: IngestReport }> => json(`/jobs/${encodeURIComponent(jobId)}/results`);

export const deleteDataset = async (id: string): Promise<void> => {
  await request(`/datasets/${encodeURIComponent(id)}`, { method: 'DELETE' });
};

export const deleteUpload = async (id: string): Promise<void> => {
  await request(`/uploads/${encodeURIComponent(id)}`, { method: 'DELETE' });
};

/**
 * Sends a file and reports the bytes sent; the server refuses a file whose digest differs. Uses XMLHttpRequest, because
 * fetch reports no progress while sending.
 */
export function sendFile(file: Blob, name: string, sha256: string, signal: AbortSignal, progress: (bytes: number) => void): Promise<Upload> {
  return new Promise((resolve, reject) => {
    const exchange = new XMLHttpRequest();
    exchange.open('POST', address('/uploads', { name, sha256 }));
    exchange.responseType = 'text';
    exchange.setRequestHeader('Content-Type', 'application/octet-stream');
    exchange.upload.onprogress = ({ loaded }) => progress(loaded);
    exchange.onload = () => {
      noteRefusal(exchange.status);
      const answer = bodyOf(exchange);
      if (exchange.status === 201 && answer) resolve(answer as Upload);
      else reject(new ApiError({ ...silence, title: exchange.statusText, status: exchange.status, detail: `The server answered ${exchange.status}.`, ...answer }));
    };
    exchange.onerror = () => reject(new ApiError(silence));
    exchange.onabort = () => reject(new DOMException('Sending was cancelled.', 'AbortError'));
    signal.addEventListener('abort', () => exchange.abort(), { once: true });
    if (signal.aborted) exchange.abort();
    else exchange.send(file);
  });
}

function bodyOf({ responseText }: XMLHttpRequest): object | undefined {
  try {
    const read: unknown = JSON.parse(responseText);
    return typeof read === 'object' && read !== null ? read : undefined;
  } catch {
    return undefined;
  }
}

const answered = { 'Content-Type': 'application/json', Prefer: 'respond-sync' };

/** Plans synchronously and returns the plan; only for requests that take a moment. */
export const planNow = (inputs: PlanInputs): Promise<PlanResults> =>
  json('/processes/plan-route/execution', { method: 'POST', headers: answered, body: JSON.stringify({ inputs }) });

export const evaluateRoute = (inputs: EvaluateInputs, signal: AbortSignal): Promise<EvaluationResults> =>
  json('/processes/evaluate-route/execution', { method: 'POST', headers: answered, body: JSON.stringify({ inputs }), signal });

export const reach = (inputs: ReachInputs, signal: AbortSignal): Promise<{ reach: Reach }> =>
  json('/processes/reach/execution', { method: 'POST', headers: answered, body: JSON.stringify({ inputs }), signal });

export const jobs = (): Promise<{ jobs: JobStatus[] }> => json(address('/jobs', { limit: 50 }));

/** Returns the job at its next change, or after `wait_s`. */
export const job = (id: string, wait_s: number, signal: AbortSignal): Promise<JobStatus> =>
  json(`/jobs/${encodeURIComponent(id)}`, { headers: { Prefer: `wait=${wait_s}` }, signal });

export const jobResults = (id: string): Promise<PlanResults> => json(`/jobs/${encodeURIComponent(id)}/results`);

export const dismissJob = (id: string): Promise<JobStatus> => json(`/jobs/${encodeURIComponent(id)}`, { method: 'DELETE' });

export const simulationResults = (jobId: string): Promise<{ simulation: Simulation | { status: 'cancelled' } }> =>
  json(`/jobs/${encodeURIComponent(jobId)}/results`);

export const simulations = (planId: string): Promise<{ simulations: SimulationSummary[] }> =>
  json(address('/simulations', { plan_id: planId, limit: 100 }));

export const simulation = (id: string): Promise<Simulation> => json(`/simulations/${encodeURIComponent(id)}`);

export const flight = (id: string, run: number): Promise<Flight> => json(`/simulations/${encodeURIComponent(id)}/flights/${run}`);

export const deleteSimulation = async (id: string): Promise<void> => {
  await request(`/simulations/${encodeURIComponent(id)}`, { method: 'DELETE' });
};

/** The address from which the browser downloads the flights of a simulation. */
export const tracksAddress = (id: string, format: 'nc' | 'geojson'): string => `/simulations/${encodeURIComponent(id)}/tracks.${format}`;
