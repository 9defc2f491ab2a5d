import { computed } from '@preact/signals';
import type { IcebergProperties } from '../../contract/data_types';
import { requestFields } from '../../contract/request_fields';
import { draft, numberIn } from '../setup/draft';
import { day_ms, hour_ms } from '../time';

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

/** Least opacity of a sighting, however old, because there is still a berg. */
const faintest = 0.35;

/** Opacity of a sighting: paler with age, down to the age at which plans ignore it. */
export function strengthOf({ observed }: IcebergProperties, at_ms: number, limit_days: number): number {
  const spent = (at_ms - Date.parse(observed)) / Math.max(limit_days * day_ms, hour_ms);
  return 1 - (1 - faintest) * Math.min(Math.max(spent, 0), 1);
}

/** The appearance of the symbol of a sighting at a time. */
export interface Look {
  stale: boolean;
  strength: number;
}

/** Number of opacity steps: each step redraws all symbols, and a playing clock passes many hours. */
const strengthSteps = 20;

export const lookOf = (berg: IcebergProperties, at_ms: number, limit_days: number): Look => ({
  stale: isStale(berg, at_ms),
  strength: Math.round(strengthSteps * strengthOf(berg, at_ms, limit_days)) / strengthSteps,
});

const metresIn = (text: string, usual: number): number => {
  const value = numberIn(text);
  return value !== undefined && value >= 0 ? value : usual;
};

/**
 * Settings of the set-up for the keep-out distance, computed once because each clock step needs them for every iceberg.
 */
const keepOutRules = computed(() => {
  const { margin_m, max_inflation_m } = requestFields;
  return { margin_m: metresIn(draft.value.margin_m, margin_m.usual), most_m: metresIn(draft.value.max_inflation_m, max_inflation_m.usual) };
});

/** The largest position error that counts in the keep-out distance. */
export const allowance_m = computed(() => keepOutRules.value.most_m);

/** The keep-out distance from the expected position of an iceberg: hull, margin and position error, the error up to the bound of the set-up. */
export function keepOut_m(safe_length_m: number, error_m: number): number {
  const { margin_m, most_m } = keepOutRules.value;
  return safe_length_m / 2 + margin_m + Math.min(error_m, most_m);
}

/** Radii around a sighting: hull and margin alone, and the keep-out distance, which adds the position error as far as it counts. */
export function keepOutRadii_m({ safe_length_m, position_uncertainty_m }: IcebergProperties): { kept_m: number; uncertain_m: number } {
  return { kept_m: keepOut_m(safe_length_m, 0), uncertain_m: keepOut_m(safe_length_m, position_uncertainty_m ?? 0) };
}
