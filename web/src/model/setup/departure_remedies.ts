import type { PlanInputs } from '../../contract/types';
import { chosenCurrents } from '../datasets';
import { formOf } from '../fields';
import type { Remedy } from '../job';
import { fieldOf, shortTime } from '../time';

/** What a pilot would try first if the departure lies outside the period of the currents; nothing if it lies within. */
export function departureRemedies({ depart }: Partial<PlanInputs>): Remedy[] {
  const { time_start, time_end } = chosenCurrents.value ?? {};
  if (!depart || !time_start || !time_end) return [];
  const [depart_ms, start_ms, end_ms] = [depart, time_start, time_end].map((time) => Date.parse(time)) as [number, number, number];
  if (depart_ms >= start_ms && depart_ms <= end_ms) return [];
  return [
    { title: `Depart when the currents begin, ${shortTime(start_ms)}`, part: { depart: fieldOf(start_ms) } },
    { title: formOf('steady').label, part: { steady: true } },
    { title: 'Plan without currents', part: { currents: 'none' } },
  ];
}
