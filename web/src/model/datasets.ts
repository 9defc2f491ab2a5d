import { computed, signal } from '@preact/signals';
import type { Box, DamagedThing, Dataset, DatasetKind, PlanningKind, StoredDatasets, Vehicle } from '../contract/data_types';
import { intersection } from '../geo/boxes';
import { time_ms } from './clock';
import { severalIn, withoutMissing } from './setup/data_choice';
import { draft, emptyDraft, fill } from './setup/draft';
import { icebergs } from './field';
import { hour_ms } from './time';

/** All stored datasets, newest first; undefined until the server has answered. */
export const datasets = signal<Dataset[] | undefined>(undefined);
export const vehicles = signal<Vehicle[]>([]);

/** Datasets that the store can no longer read, with the reason. The list of all datasets lacks them. */
export const damagedDatasets = signal<DamagedThing[]>([]);

export function takeStored(stored: StoredDatasets): void {
  datasets.value = stored.datasets;
  damagedDatasets.value = stored.damaged ?? [];
}

/** Why the server could not be read at start; empty if it could. */
export const connectionFault = signal<string | undefined>(undefined);

export const isEmptyStore = computed(() => datasets.value?.length === 0 && damagedDatasets.value.length === 0);

export const ofKind = (kind: DatasetKind): Dataset[] => (datasets.value ?? []).filter((dataset) => dataset.kind === kind);

const kinds: PlanningKind[] = ['bathymetry', 'currents', 'ice', 'icebergs', 'coastline', 'tides', 'wind', 'zones'];

/** The id of the dataset that holds the manual entries of a kind. Plans obey it together with the datasets from files. */
export const byHand = (kind: 'icebergs' | 'zones'): string => `${kind}-by-hand`;

/** Nodes per square degree, to compare the resolution of grids. */
export const nodesPerDegree2 = ({ bbox: [west, south, east, north], rows_accepted }: Dataset): number =>
  rows_accepted / (Math.max(1e-9, east >= west ? east - west : east - west + 360) * Math.max(1e-9, north - south));

/**
 * The datasets of a kind that the draft asks for, in order of priority. Where none was chosen, that is the newest; of icebergs and
 * depths it is all of them, and the finest depths come first.
 */
export function chosenAll(kind: PlanningKind): Dataset[] {
  const wish = draft.value[kind];
  const candidates = ofKind(kind);
  if (wish === 'none') return [];
  if (wish === 'all') return candidates;
  if (wish === 'newest' && kind === 'bathymetry') return [...candidates].sort((a, b) => nodesPerDegree2(b) - nodesPerDegree2(a));
  if (wish === 'newest') return kind === 'icebergs' ? candidates : candidates.slice(0, 1);
  const ids = severalIn(wish) ?? [wish];
  return ids.flatMap((id) => candidates.find((dataset) => dataset.id === id) ?? []);
}

/** The first dataset of `chosenAll`, which the map shows. */
export const chosen = (kind: PlanningKind): Dataset | undefined => chosenAll(kind)[0];

/** The datasets that the set-up names, without those of icebergs: plans under way may name further ones. */
export const namedDatasets = computed<string[]>(() =>
  kinds.flatMap((kind) => {
    const wish = draft.value[kind];
    return kind === 'icebergs' || wish === 'newest' || wish === 'all' ? [] : chosenAll(kind).map(({ id }) => id);
  }),
);

/** Whether the set-up uses a dataset. Icebergs are used where the dataset is named, or holds the newest sighting of a berg. */
export function isInUse({ id, kind }: Dataset): boolean {
  const isJoined = kind === 'icebergs' && draft.value.icebergs === 'newest';
  if (isJoined) return icebergs.value.some(({ properties }) => properties.dataset_id === id);
  return kinds.some((known) => known === kind && chosenAll(known).some((one) => one.id === id));
}

/** Drops chosen datasets that are no longer stored, and returns the kinds of those that were named. Damaged datasets stay chosen, so that nobody plans without them by accident. */
export function forgetMissing(): PlanningKind[] {
  const lost: PlanningKind[] = [];
  for (const kind of kinds) {
    const left = withoutMissing(draft.value[kind], (id) => ofKind(kind).some((dataset) => dataset.id === id) || damagedDatasets.value.some((thing) => thing.id === id));
    if (left === draft.value[kind]) continue;
    lost.push(kind);
    fill({ [kind]: left ?? emptyDraft[kind] });
  }
  return lost;
}

export const chosenBathymetry = computed(() => chosen('bathymetry'));
export const chosenCurrents = computed(() => chosen('currents'));
export const chosenIcebergs = computed(() => chosenAll('icebergs'));
/** Of the chosen datasets of icebergs, the one with the newest sighting. */
export const lastSighted = computed<Dataset | undefined>(() =>
  chosenIcebergs.value.reduce<Dataset | undefined>((newest, one) => ((one.time_end ?? '') > (newest?.time_end ?? '') ? one : (newest ?? one)), undefined),
);
export const chosenCoastline = computed(() => chosen('coastline'));
/**
 * The newest sea ice that covers the clock's time, of the datasets that plans may use; otherwise the nearest in time.
 */
export const chosenSeaIce = computed(() => {
  const candidates = draft.value.ice === 'newest' ? ofKind('ice') : chosenAll('ice');
  const tellsOf = ({ time_start, time_end }: Dataset): boolean =>
    time_start !== null && time_end !== null && Date.parse(time_start) <= time_ms.value && time_ms.value <= Date.parse(time_end);
  const away_ms = ({ time_start, time_end }: Dataset): number =>
    Math.max(Date.parse(time_start ?? '') - time_ms.value, time_ms.value - Date.parse(time_end ?? ''));
  return candidates.find(tellsOf) ?? candidates.reduce<Dataset | undefined>((best, one) => (best && !(away_ms(one) < away_ms(best)) ? best : one), undefined);
});

/**
 * The area shown first: where both currents and depths are known, otherwise where one of them is, otherwise the area of
 * ice or of a glider.
 */
export const homeBox = computed<Box>(() => {
  const currents = chosenCurrents.value?.bbox;
  const bathymetry = chosenBathymetry.value?.bbox;
  const both = currents && bathymetry ? intersection(currents, bathymetry) : undefined;
  return both ?? currents ?? bathymetry ?? chosenIcebergs.value[0]?.bbox ?? ofKind('glider-tracks')[0]?.bbox ?? [-75, 58, -15, 84];
});

/** The times of a dataset's steps, ascending; whole hours where the server does not list them. */
function timesOf(dataset: Dataset | undefined): number[] {
  if (dataset?.times?.length) return dataset.times.map((time) => Date.parse(time));
  if (!dataset?.time_start || !dataset.time_end) return [];
  const end_ms = Date.parse(dataset.time_end);
  const times: number[] = [];
  for (let time = Date.parse(dataset.time_start); time <= end_ms && times.length < 20_000; time += hour_ms) times.push(time);
  return times;
}

export const currentTimes_ms = computed(() => timesOf(chosenCurrents.value));
export const seaIceTimes_ms = computed(() => timesOf(chosenSeaIce.value));

/** Whether any data in use are marked as synthetic. */
export const isSynthetic = computed(() =>
  [chosenBathymetry.value, chosenCurrents.value, chosenCoastline.value, chosenSeaIce.value, ...chosenIcebergs.value.filter(isInUse)].some(
    (used) => used && [used.name, used.file_name, ...used.warnings].some((text) => /synthetic|invented|made.up/i.test(text)),
  ),
);
