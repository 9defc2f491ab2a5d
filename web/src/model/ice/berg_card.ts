import { computed, signal } from '@preact/signals';
import type { IcebergFeature } from '../../contract/data_types';
import type { Plan } from '../../contract/types';
import { circle } from '../../geo/geodesic';
import { time_ms } from '../clock';
import { datasets } from '../datasets';
import { drifts, expectedAt, type Expected } from './drift';
import { icebergs } from '../field';
import { routeOf } from '../plan/plans';
import { probed } from '../probe';
import { ask } from '../view';
import { keepOutRadii_m } from './icebergs';

/** The name of the iceberg whose card is open. The card shows the newest sighting of that name. */
export const openBergId = signal<string | undefined>(undefined);

export const openBerg = computed<IcebergFeature | undefined>(() => icebergs.value.find(({ properties }) => properties.berg_id === openBergId.value));

/** How much of the sea is shown around an iceberg, as a multiple of its keep-out distance. */
const aroundIt = 4;

/**
 * Opens the card of an iceberg and shows it on the map. If it is not in view, the map shows the plan, which passes near it, until the sighting is
 * read.
 */
export function showIceberg(berg_id: string, plan: Plan): void {
  openBergId.value = berg_id;
  probed.value = undefined;
  const berg = icebergs.peek().find(({ properties }) => properties.berg_id === berg_id);
  if (!berg) {
    ask({ do: 'fit', places: routeOf(plan) });
    return;
  }
  const { coordinates } = berg.geometry;
  ask({ do: 'fit', places: circle(coordinates, aroundIt * keepOutRadii_m(berg.properties).uncertain_m) });
}

/** The number of sightings of the iceberg on the server; undefined until it has answered. */
export const bergHistory = signal<{ berg_id: string; sightings: number; from: string } | undefined>(undefined);

const openDrift = computed(() => drifts.value.find(({ berg_id }) => berg_id === openBergId.value));

/** Where the iceberg is expected at the clock's time; undefined outside the period of its forecast. */
export const expectedNow = computed<Expected | undefined>(() => openDrift.value && expectedAt(openDrift.value, time_ms.value));

export const forecastEnd_ms = computed<number | undefined>(() => {
  const end = openDrift.value?.time.at(-1);
  return end === undefined ? undefined : Date.parse(end);
});

/** The dataset that holds the sighting of the iceberg. */
export const bergSource = computed<string | undefined>(() => datasets.value?.find(({ id }) => id === openBerg.value?.properties.dataset_id)?.name);
