import type { Alternative, Plan } from '../../contract/types';
import type { Draft } from '../setup/draft';
import { baselineId, plans, select, shown } from './plans';
import { duration } from '../time';

/** An alternative whose plan is still stored. */
export interface StoredAlternative {
  alternative: Alternative;
  plan: Plan;
}

/** The alternatives to a plan that are still stored, best first. */
export function alternativesTo({ alternatives = [] }: Plan): StoredAlternative[] {
  return alternatives.flatMap((alternative) => {
    const plan = plans.value.find(({ plan_id }) => plan_id === alternative.plan_id);
    return plan ? [{ alternative, plan }] : [];
  });
}

/** The plan that another plan is an alternative to, with its entry there. */
export function bestOf({ plan_id }: Plan): { best: Plan; alternative: Alternative } | undefined {
  for (const best of plans.value) {
    const alternative = best.alternatives?.find((each) => each.plan_id === plan_id);
    if (alternative) return { best, alternative };
  }
  return undefined;
}

/** "7 h 51 min later" than the plan. */
export function laterThan(plan: Plan, { arrival }: Alternative): string {
  const later_s = (Date.parse(arrival) - Date.parse(plan.arrival)) / 1000;
  if (duration(Math.abs(later_s)) === duration(0)) return 'at the same time';
  return `${duration(Math.abs(later_s))} ${later_s > 0 ? 'later' : 'earlier'}`;
}

/** Puts a plan and its alternatives on the map, and nothing else, for a comparison with the plan as baseline. */
export function showBesideAlternatives(plan: Plan): void {
  shown.value = [plan, ...alternativesTo(plan).map((other) => other.plan)].map(({ plan_id }) => plan_id);
  baselineId.value = plan.plan_id;
  select(plan.plan_id);
}

/** Why a set-up cannot request alternatives, by the server's rules; undefined if it can. */
export function whyNoAlternatives({ depart_until, arrive_by, method }: Draft): string | undefined {
  if (depart_until.trim() !== '') return 'Alternatives are for one departure. Choose it first, then clear “Latest departure”.';
  if (arrive_by.trim() !== '') return 'Alternatives are for one departure. Choose it first, then clear “Latest arrival”.';
  if (method === 'direct') return 'The straight line has no alternatives.';
  return undefined;
}
