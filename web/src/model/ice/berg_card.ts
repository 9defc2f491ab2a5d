import { computed, signal } from '@preact/signals';
import type { IcebergFeature } from '../../contract/data_types';
import { time_ms } from '../clock';
import { datasets } from '../datasets';
import { drifts, expectedAt, type Expected } from './drift';
import { icebergs } from '../field';

/** The name of the iceberg whose card is open. The card shows the newest sighting of that name. */
export const openBergId = signal<string | undefined>(undefined);

export const openBerg = computed<IcebergFeature | undefined>(() => icebergs.value.find(({ properties }) => properties.berg_id === openBergId.value));

/** How many sightings of it the server holds; undefined until it has answered. */
export const bergHistory = signal<{ berg_id: string; sightings: number; from: string } | undefined>(undefined);

const openDrift = computed(() => drifts.value.find(({ berg_id }) => berg_id === openBergId.value));

/** Where it is expected at the clock's time; undefined outside the time of its forecast. */
export const expectedNow = computed<Expected | undefined>(() => openDrift.value && expectedAt(openDrift.value, time_ms.value));

export const forecastEnd_ms = computed<number | undefined>(() => {
  const end = openDrift.value?.time.at(-1);
  return end === undefined ? undefined : Date.parse(end);
});

/** The dataset that its sighting comes from. */
export const bergSource = computed<string | undefined>(() => datasets.value?.find(({ id }) => id === openBerg.value?.properties.dataset_id)?.name);
