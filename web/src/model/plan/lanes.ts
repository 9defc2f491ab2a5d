import type { Plan } from '../../contract/types';
import type { ShownPlan } from './plans';

/** How many bars the time line has room for, one above the other. */
export const laneCount = 6;

export interface Lanes {
  bars: { shown: ShownPlan; lane: number }[];
  left: ShownPlan[]; // without a bar
}

const span = ({ departure, arrival }: Plan): [number, number] => [Date.parse(departure), Date.parse(arrival)];

/** Bars for plans: each in the first lane where it overlaps no other. The selected plan always has one. */
export function lanesOf(plans: ShownPlan[], selectedId: string | undefined): Lanes {
  const ends: [number, number][][] = Array.from({ length: laneCount }, () => []);
  const lanes: Lanes = { bars: [], left: [] };
  const first = plans.filter(({ plan }) => plan.plan_id === selectedId);
  for (const shown of [...first, ...plans.filter((each) => !first.includes(each))]) {
    const [from, to] = span(shown.plan);
    const lane = ends.findIndex((taken) => taken.every(([begin, end]) => to < begin || end < from));
    if (lane < 0) lanes.left.push(shown);
    else {
      ends[lane]?.push([from, to]);
      lanes.bars.push({ shown, lane });
    }
  }
  return lanes;
}
