import { computed, signal } from '@preact/signals';
import type { CoastFeature, IcebergFeature, Position } from '../contract/data_types';
import { sample, samplePair, type Grid, type TimedPair } from '../geo/grid';

/** The data that are loaded for the area in view. */
export const bathymetry = signal<Grid | undefined>(undefined);
export const coast = signal<CoastFeature[]>([]);

/** Currents around the clock's time; undefined where there are none, and then `currentsFault` says why. */
export const currents = signal<TimedPair | undefined>(undefined);
export const currentsFault = signal<string | undefined>(undefined);

/** Sea ice around the clock's time: the share of the sea that it covers, and the thickness of level ice in metres. */
export const seaIce = signal<TimedPair | undefined>(undefined);
export const seaIceFault = signal<string | undefined>(undefined);

/** The newest sighting of each iceberg that counts for a departure at the clock's time, and the first moment they were asked for. */
export const icebergs = signal<IcebergFeature[]>([]);
export const icebergsAsOf_ms = signal<number | undefined>(undefined);

/** How many requests for data are under way. */
export const loading = signal(0);

export const isLoading = computed(() => loading.value > 0);

export interface Reading {
  depth_m: number | undefined;
  east_m_s: number | undefined;
  north_m_s: number | undefined;
  concentration: number | undefined;
  thickness_m: number | undefined;
}

const known = (value: number): number | undefined => (Number.isFinite(value) ? value : undefined);

/** Depth, current and sea ice at a place, from the loaded data. */
export function readingAt([lon, lat]: Position): Reading {
  const grid = bathymetry.value;
  const pair = currents.value;
  const ice = seaIce.value;
  return {
    depth_m: grid && known(sample(grid, 0, lon, lat)),
    east_m_s: pair && known(samplePair(pair, 0, lon, lat)),
    north_m_s: pair && known(samplePair(pair, 1, lon, lat)),
    concentration: ice && known(samplePair(ice, 0, lon, lat)),
    thickness_m: ice && known(samplePair(ice, 1, lon, lat)),
  };
}
