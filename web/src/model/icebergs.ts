import type { IcebergProperties } from '../api/data_types';
import { draft } from './draft';
import { hour_ms } from './time';

/** After this a sighting no longer says where the berg is. */
export const validity_h = 24;

/** Above this many, small bergs are drawn without rings. */
export const crowd = 300;

const sizes_px: Record<string, number> = {
  growler: 4, bergy_bit: 5, small: 6, medium: 7.5, large: 9, very_large: 11, unknown: 7.5, radar_target: 6.5,
};

export const symbolSize_px = (size: string): number => sizes_px[size] ?? 7.5;

export const sizeTitle = (size: string): string => size.replaceAll('_', ' ');

export function isStale({ observed }: IcebergProperties, at_ms: number): boolean {
  return at_ms - Date.parse(observed) > validity_h * hour_ms;
}

/**
 * Radii around a berg: half its safe length and the margin of the set-up; and the same with the stated uncertainty of
 * its position, which is what the planner keeps out of.
 */
export function safetyRadii_m(berg: IcebergProperties): { kept_m: number; uncertain_m: number } {
  const margin_m = Number(draft.value.margin_m.replace(',', '.'));
  const kept_m = berg.safe_length_m / 2 + (Number.isFinite(margin_m) && margin_m >= 0 ? margin_m : 0);
  return { kept_m, uncertain_m: kept_m + (berg.position_uncertainty_m ?? 0) };
}
