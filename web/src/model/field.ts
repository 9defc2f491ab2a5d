import { computed, signal } from '@preact/signals';
import type { CoastFeature, IcebergFeature } from '../contract/data_types';
import type { Grid, TimedPair } from '../geo/grid';

/** The data that are loaded for the area in view. */
export const bathymetry = signal<Grid | undefined>(undefined);
export const coast = signal<CoastFeature[]>([]);

/** Currents around the clock's time; undefined where there are none, and then `currentsFault` says why. */
export const currents = signal<TimedPair | undefined>(undefined);
export const currentsFault = signal<string | undefined>(undefined);

/** Sea ice around the clock's time: the share of the sea that it covers, and the thickness of level ice in metres. */
export const seaIce = signal<TimedPair | undefined>(undefined);
export const seaIceFault = signal<string | undefined>(undefined);

/**
 * For each iceberg the newest sighting that counts for a departure at the clock's time; and the first time for which
 * they were requested.
 */
export const icebergs = signal<IcebergFeature[]>([]);
export const icebergsAsOf_ms = signal<number | undefined>(undefined);

/** How many requests for data are under way. */
export const loading = signal(0);

export const isLoading = computed(() => loading.value > 0);
