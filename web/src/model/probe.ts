import { computed, signal } from '@preact/signals';
import type { PlanningKind, Position } from '../contract/data_types';
import type { Probe } from '../contract/types';
import { directionTowards_deg } from '../geo/vectors';
import { namedDatasets } from './datasets';
import { draft } from './setup/draft';
import { icebergChoice } from './setup/iceberg_choice';
import { seaIceInWords } from './ice/sea_ice';
import { course, depth, none, speed } from './units';

/** The answer to the last click of the probe tool. */
export const probed = signal<{ lon: number; lat: number; answer: Probe | undefined; fault: string | undefined } | undefined>(undefined);

/** The last answer for the pointer, and where it was then. */
export const readOut = signal<{ place: Position; answer: Probe } | undefined>(undefined);

/** The datasets to probe. For a kind with none of them, the server uses those that a plan would use. */
export const probedDatasets = computed<string[]>(() => [...namedDatasets.value, ...(icebergChoice.value?.datasets ?? [])]);

/** Whether plans of the set-up, and therefore the map, do not use a kind of data. */
export const isLeftOut = (kind: PlanningKind): boolean => draft.value[kind] === 'none';

export const bedInWords = ({ land, depth_m }: Probe): string => (land ? 'land' : depth(depth_m));

export function currentInWords({ currents: { u_m_s, v_m_s } }: Probe): string {
  return u_m_s === null || v_m_s === null ? none : `${speed(Math.hypot(u_m_s, v_m_s))} to ${course(directionTowards_deg(u_m_s, v_m_s))}`;
}

/** "1.87 m above lowest astronomical tide"; undefined if none is stored there and then. */
export function levelInWords({ water_level: { height_m, datum } }: Probe): string | undefined {
  if (height_m === null) return undefined;
  return `${Math.abs(height_m).toFixed(2)} m ${height_m < 0 ? 'below' : 'above'} the datum (${datum ?? 'not named'})`;
}

export const iceInWords = ({ ice_concentration, ice }: Probe): string => seaIceInWords(ice_concentration, ice.thickness_m);
