import { computed, signal } from '@preact/signals';
import type { Box, Dataset, DatasetKind, Vehicle } from '../api/types';
import { intersection } from '../geo/boxes';
import { draft } from './draft';
import { hour_ms } from './time';

/** Everything the store holds, newest first; undefined until the server has answered. */
export const datasets = signal<Dataset[] | undefined>(undefined);
export const vehicles = signal<Vehicle[]>([]);

/** Why the server could not be read at start, if so. */
export const connectionFault = signal<string | undefined>(undefined);

export const isEmptyStore = computed(() => datasets.value?.length === 0);

export const ofKind = (kind: DatasetKind): Dataset[] => (datasets.value ?? []).filter((dataset) => dataset.kind === kind);

/** The id of what people made by hand of a kind: a dataset of its own, which plans obey beside those of files. */
export const byHand = (kind: 'icebergs' | 'zones'): string => `${kind}-by-hand`;

/** The dataset of a kind that the draft asks for and the map therefore shows: the newest unless another was chosen. */
export function chosen(kind: DatasetKind): Dataset | undefined {
  const wish = draft.value[kind];
  if (wish === 'none') return undefined;
  const candidates = ofKind(kind);
  if (wish === 'newest') return candidates.find(({ id }) => id !== byHand('icebergs')) ?? candidates[0];
  return candidates.find((dataset) => dataset.id === wish);
}

/** Whether the set-up makes use of a dataset; of zones all are obeyed together. */
export const isInUse = ({ id, kind }: Dataset): boolean => draft.value[kind] === 'all' || chosen(kind)?.id === id || besideIcebergs.value?.id === id;

/** What was reported by hand beside the chosen icebergs; neither hides the other. */
export const besideIcebergs = computed(() => {
  const reported = draft.value.icebergs === 'newest' ? ofKind('icebergs').find(({ id }) => id === byHand('icebergs')) : undefined;
  return reported === chosen('icebergs') ? undefined : reported;
});

export const chosenBathymetry = computed(() => chosen('bathymetry'));
export const chosenCurrents = computed(() => chosen('currents'));
export const chosenIcebergs = computed(() => chosen('icebergs'));
export const chosenCoastline = computed(() => chosen('coastline'));

/** The part of the Earth to open on: where currents and depths are both known, else whichever is. */
export const homeBox = computed<Box>(() => {
  const currents = chosenCurrents.value?.bbox;
  const bathymetry = chosenBathymetry.value?.bbox;
  const both = currents && bathymetry ? intersection(currents, bathymetry) : undefined;
  return both ?? currents ?? bathymetry ?? chosenIcebergs.value?.bbox ?? [-75, 58, -15, 84];
});

/** Moments for which currents are stored, ascending; whole hours where the server keeps its list to itself. */
export const currentTimes_ms = computed<number[]>(() => {
  const dataset = chosenCurrents.value;
  if (dataset?.times?.length) return dataset.times.map((time) => Date.parse(time));
  if (!dataset?.time_start || !dataset.time_end) return [];
  const end_ms = Date.parse(dataset.time_end);
  const times: number[] = [];
  for (let time = Date.parse(dataset.time_start); time <= end_ms && times.length < 20_000; time += hour_ms) times.push(time);
  return times;
});

/** Whether any data in use call themselves made up. */
export const isSynthetic = computed(() =>
  [chosenBathymetry, chosenCurrents, chosenIcebergs, chosenCoastline].some(({ value }) =>
    value ? [value.name, value.file_name, ...value.warnings].some((text) => /synthetic|invented|made.up/i.test(text)) : false,
  ),
);
