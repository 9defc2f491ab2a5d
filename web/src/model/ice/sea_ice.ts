import { computed } from '@preact/signals';
import { requestFields } from '../../contract/request_fields';
import { heldStep, setSpan, setTime, time_ms } from '../clock';
import { seaIceTimes_ms } from '../datasets';
import { draft, numberIn } from '../setup/draft';
import { factorOf } from '../fields';
import { day_ms } from '../time';
import { none } from '../units';

/** The longest gap between two steps that the server fills (ocean::longest_ice_gap). Ice charts come once a week. */
export const longestSeaIceGap_ms = 8 * day_ms;

/** How long before the first step and after the last one plans hold the ice of that step (ocean::longest_ice_hold). */
export const longestSeaIceHold_ms = 3 * day_ms;

/** Concentrations at which the colour changes: the ice edge, then open, close and very close ice (WMO No. 259). */
export const seaIceLevels = [0.15, 0.4, 0.7, 0.9] as const;
export const iceEdge = seaIceLevels[0];

const surfacingField = 'under_ice.max_concentration_to_surface';

/** The largest concentration in which the vehicle of the set-up may surface. */
export const surfacingLimit = computed<number>(() => {
  const stated = numberIn(draft.value[surfacingField]);
  const share = stated === undefined ? NaN : stated * factorOf(surfacingField);
  return share >= 0 && share <= 1 ? share : requestFields[surfacingField].usual;
});

/** The step of the data nearest to the clock's time; undefined without data. */
export const nearestSeaIceStep_ms = computed<number | undefined>(() =>
  seaIceTimes_ms.value.reduce<number | undefined>(
    (best, step) => (best === undefined || Math.abs(step - time_ms.value) < Math.abs(best - time_ms.value) ? step : best),
    undefined,
  ),
);

/** The step that is held at a clock's time outside the data; undefined inside the data, and where nothing is held. */
export const heldSeaIceStep_ms = computed<number | undefined>(() => {
  const times = seaIceTimes_ms.value;
  const held = heldStep(times, time_ms.value, longestSeaIceHold_ms);
  return held && times[held.before];
});

/** Sets the clock to the step nearest to its time, and extends the period of the clock to that step. */
export function goToSeaIce(): void {
  const step_ms = nearestSeaIceStep_ms.peek();
  if (step_ms === undefined) return;
  setSpan('sea ice', { start_ms: step_ms, end_ms: step_ms });
  setTime(step_ms);
}

/** "70 %, 0.6 m thick"; the dash where the data have no value, and "none" over open water. */
export function seaIceInWords(concentration: number | null | undefined, thickness_m: number | null | undefined): string {
  if (typeof concentration !== 'number') return none;
  if (concentration < 0.005) return 'none'; // rounds to 0 %
  const thick = typeof thickness_m === 'number' ? `${thickness_m.toFixed(1)} m thick` : 'thickness not known';
  return `${Math.round(100 * concentration)} %, ${thick}`;
}
