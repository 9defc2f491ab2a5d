import { computed, signal } from '@preact/signals';
import type { Box, DamagedThing, Dataset, DatasetKind, PlanningKind, StoredDatasets, Vehicle } from '../api/data_types';
import { intersection } from '../geo/boxes';
import { time_ms } from './clock';
import { severalIn, withoutMissing } from './data_choice';
import { draft, emptyDraft, fill } from './draft';
import { icebergs } from './field';
import { hour_ms } from './time';

/** Everything the store holds, newest first; undefined until the server has answered. */
export const datasets = signal<Dataset[] | undefined>(undefined);
export const vehicles = signal<Vehicle[]>([]);

/** What the store says of datasets that it can no longer read; the other list lacks them. */
export const damagedDatasets = signal<DamagedThing[]>([]);

export function takeStored(stored: StoredDatasets): void {
  datasets.value = stored.datasets;
  damagedDatasets.value = stored.damaged ?? [];
}

/** Why the server could not be read at start, if so. */
export const connectionFault = signal<string | undefined>(undefined);

export const isEmptyStore = computed(() => datasets.value?.length === 0 && damagedDatasets.value.length === 0);

export const ofKind = (kind: DatasetKind): Dataset[] => (datasets.value ?? []).filter((dataset) => dataset.kind === kind);

const kinds: PlanningKind[] = ['bathymetry', 'currents', 'ice', 'icebergs', 'coastline', 'tides', 'wind', 'zones'];

/** The id of what people made by hand of a kind: a dataset of its own, which plans obey beside those of files. */
export const byHand = (kind: 'icebergs' | 'zones'): string => `${kind}-by-hand`;

/** Nodes in a square degree: what tells a fine grid from a coarse one. */
export const nodesPerDegree2 = ({ bbox: [west, south, east, north], rows_accepted }: Dataset): number =>
  rows_accepted / (Math.max(1e-9, east >= west ? east - west : east - west + 360) * Math.max(1e-9, north - south));

/**
 * The datasets of a kind that the draft asks for, in their rank: the newest unless others were chosen; of icebergs, which plans
 * join, every one, and of depths, too, the finest first.
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

/** The first of them, which the map shows. */
export const chosen = (kind: PlanningKind): Dataset | undefined => chosenAll(kind)[0];

/** Whether the set-up makes use of a dataset: of icebergs where it is named, or has the last word on one now. */
export function isInUse({ id, kind }: Dataset): boolean {
  const isJoined = kind === 'icebergs' && draft.value.icebergs === 'newest';
  if (isJoined) return icebergs.value.some(({ properties }) => properties.dataset_id === id);
  return kinds.some((known) => known === kind && chosenAll(known).some((one) => one.id === id));
}

/** Lets go of datasets that are no longer stored, but not of damaged ones, without which nobody may plan unawares; the kinds of those that the set-up had asked for by name. */
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
/** Of the icebergs chosen the dataset with the newest sighting. */
export const lastSighted = computed<Dataset | undefined>(() =>
  chosenIcebergs.value.reduce<Dataset | undefined>((newest, one) => ((one.time_end ?? '') > (newest?.time_end ?? '') ? one : (newest ?? one)), undefined),
);
export const chosenCoastline = computed(() => chosen('coastline'));
/** Of the sea ice that plans may take the newest that tells of the clock's time; where none does the nearest in time. */
export const chosenSeaIce = computed(() => {
  const candidates = draft.value.ice === 'newest' ? ofKind('ice') : chosenAll('ice');
  const tellsOf = ({ time_start, time_end }: Dataset): boolean =>
    time_start !== null && time_end !== null && Date.parse(time_start) <= time_ms.value && time_ms.value <= Date.parse(time_end);
  const away_ms = ({ time_start, time_end }: Dataset): number =>
    Math.max(Date.parse(time_start ?? '') - time_ms.value, time_ms.value - Date.parse(time_end ?? ''));
  return candidates.find(tellsOf) ?? candidates.reduce<Dataset | undefined>((best, one) => (best && !(away_ms(one) < away_ms(best)) ? best : one), undefined);
});

/** The part of the Earth to open on: where currents and depths are both known, else whichever is; else where there is ice, or a glider was. */
export const homeBox = computed<Box>(() => {
  const currents = chosenCurrents.value?.bbox;
  const bathymetry = chosenBathymetry.value?.bbox;
  const both = currents && bathymetry ? intersection(currents, bathymetry) : undefined;
  return both ?? currents ?? bathymetry ?? chosenIcebergs.value[0]?.bbox ?? ofKind('glider-tracks')[0]?.bbox ?? [-75, 58, -15, 84];
});

/** Moments for which a dataset has steps, ascending; whole hours where the server keeps its list to itself. */
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

/** Whether any data in use call themselves made up. */
export const isSynthetic = computed(() =>
  [chosenBathymetry.value, chosenCurrents.value, chosenCoastline.value, chosenSeaIce.value, ...chosenIcebergs.value.filter(isInUse)].some(
    (used) => used && [used.name, used.file_name, ...used.warnings].some((text) => /synthetic|invented|made.up/i.test(text)),
  ),
);
