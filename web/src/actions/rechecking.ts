import { conditionsOf } from '../model/setup/requests';
import { routeOf } from '../model/plan/plans';
import { announce } from '../model/screen';
import { rechecks, sightingsFor, staleness, type Recheck } from '../model/stale';
import { duration, isoOf } from '../model/time';
import { ask } from '../model/view';
import { reasonTitle } from '../model/job';
import * as api from './client';
import { learnRequest } from './plan_inputs';
import type { Conditions, Plan } from '../contract/types';

/** For a plan under way: also use sightings since its departure. Ages still count at the departure. */
function sightingsSince(plan: Plan): Conditions {
  const [, newest_ms] = sightingsFor(plan);
  return newest_ms > Date.parse(plan.departure) ? { icebergs_as_of: isoOf(newest_ms) } : {};
}

/** Evaluates a plan's unchanged route with the newest data of those kinds that have newer data. */
export async function recheck(plan: Plan): Promise<void> {
  const tell = (verdict: Recheck): void => {
    rechecks.value = { ...rechecks.value, [plan.plan_id]: verdict };
  };
  tell({ state: 'pending' });
  await learnRequest(plan.plan_id);
  const renewed = Object.fromEntries(staleness(plan).map(({ kind }) => [kind, kind === 'zones' ? 'all' : 'newest']));
  const { conditions: made } = conditionsOf(plan);
  const conditions: Conditions = { ...made, ...renewed, ...sightingsSince(plan) };
  try {
    const { evaluation } = await api.evaluateRoute({ ...conditions, route: routeOf(plan) }, new AbortController().signal);
    if (evaluation.status === 'ok') {
      tell({ state: 'ok', plan: evaluation });
      announce(`The plan holds on the newest data; travel time ${duration(evaluation.travel_time_s)}.`);
    } else {
      tell({ state: 'infeasible', answer: evaluation });
      ask({ do: 'centre', place: [evaluation.at.lon, evaluation.at.lat] });
      announce(`The plan does not hold on the newest data. ${reasonTitle(evaluation.reason)}. ${evaluation.explanation}`);
    }
  } catch (error) {
    tell({ state: 'failed', detail: error instanceof Error ? error.message : String(error) });
  }
}
