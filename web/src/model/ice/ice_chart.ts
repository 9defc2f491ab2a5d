import { computed, signal } from '@preact/signals';
import type { Dataset, IceChart, IceEgg, Position } from '../../contract/data_types';
import { wrapLongitude } from '../../geo/geodesic';
import { time_ms } from '../clock';
import { chosenAll, ofKind } from '../datasets';
import { draft } from '../setup/draft';
import { longestSeaIceHold_ms } from './sea_ice';
import { age, shortTime } from '../time';

/** Charts with codes have the SIGRID-3 codes as variables and a single time. */
const isChart = ({ variables, time_start }: Dataset): boolean => variables.includes('CT') && time_start !== null;
const momentOf = ({ time_start }: Dataset): number => Date.parse(time_start ?? '');

/** The ice chart that is shown: of those that plans may use, the newest that was drawn by the clock's time. */
export const chosenChart = computed<Dataset | undefined>(() => {
  const candidates = draft.value.ice === 'newest' ? ofKind('ice') : chosenAll('ice');
  return candidates
    .filter((one) => isChart(one) && momentOf(one) <= time_ms.value)
    .reduce<Dataset | undefined>((newest, one) => (newest && momentOf(newest) >= momentOf(one) ? newest : one), undefined);
});

/** The chart's polygons for the area in view; charts stored by older versions have none. */
export const iceChart = signal<IceChart | undefined>(undefined);

/** The ice chart on the map: its age at the time of the clock, and whether plans still use it at that time. */
export const drawnChart = computed(() => {
  const chart = iceChart.value;
  const dataset = chosenChart.value;
  if (!chart || !dataset || chart.dataset_id !== dataset.id || chart.features.length === 0) return undefined;
  const age_ms = time_ms.value - momentOf(dataset);
  return { ...chart, time_ms: momentOf(dataset), age_ms, isHeld: age_ms <= longestSeaIceHold_ms };
});

/** "27 Nov 18:00Z, 30 h old" */
export const chartInWords = ({ time_ms: drawn_ms, age_ms }: { time_ms: number; age_ms: number }): string =>
  `${shortTime(drawn_ms)}, ${age(age_ms / 1000)}`;

/** The egg code of the polygon that contains a place; undefined if none does. */
export function eggAt(place: Position): IceEgg | undefined {
  return iceChart.value?.features.find(({ geometry }) => holds(geometry.coordinates, place))?.properties;
}

/** Even-odd rule over all rings, so that holes are outside. Longitudes may exceed 180. */
function holds(rings: Position[][], [lon, lat]: Position): boolean {
  let inside = false;
  for (const ring of rings) {
    const first = ring[0];
    if (!first) continue;
    for (const turn of [-360, 0, 360]) {
      const x = first[0] + wrapLongitude(lon - first[0]) + turn;
      for (let i = 1; i < ring.length; ++i) {
        const [x0 = NaN, y0 = NaN] = ring[i - 1] ?? [];
        const [x1 = NaN, y1 = NaN] = ring[i] ?? [];
        if (y0 > lat !== y1 > lat && x < x0 + ((lat - y0) / (y1 - y0)) * (x1 - x0)) inside = !inside;
      }
    }
  }
  return inside;
}

/** "6 tenths thin first-year ice, 30 to 70 cm; medium floes, 100 to 500 m" */
export const partInWords = ({ concentration, stage, form }: IceEgg['parts'][number]): string =>
  [[concentration, stage].filter(Boolean).join(' '), form].filter(Boolean).join('; ');

/** A number of tenths as charts write it on the map: "9+", "4-6"; empty over open water. */
export function shortTotal({ codes }: IceEgg): string {
  const total = codes['CT'] ?? '';
  if (['', '00', '01', '02', '55', '98', '99'].includes(total)) return '';
  if (total === '92') return '10';
  if (total === '91') return '9+';
  const [lower = '', upper = ''] = total;
  return upper === '0' ? lower : `${lower}–${upper === '1' ? '10' : upper}`;
}
