import { effect, untracked } from '@preact/signals';
import { reasonTitle } from '../model/job';
import { warnedOf } from '../model/messages';
import { add, titleOf } from '../model/plan/plans';
import { rememberRequest } from '../model/setup/requests';
import { closeSavedEdit, deliver, routeEdit, whyNotSaved, type RouteEdit, type Verdict } from '../model/plan/route_edit';
import { announce } from '../model/screen';
import { duration } from '../model/time';
import * as api from './client';
import type { Plan, PlanInputs } from '../contract/types';

/** A single change is evaluated at once. While keys are held or clicks follow quickly, the evaluation waits for a pause this long. */
const pause_ms = 80;
const quick_ms = 300;

/** Evaluates the edited route whenever it has changed; a newer request aborts the older. Call once. */
export function followRouteEdit(): void {
  let asked: string | undefined;
  let question: AbortController | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let changed_ms = -Infinity;
  let prepared: Plan | undefined;
  effect(() => {
    const edit = routeEdit.value;
    if (edit && edit.origin !== prepared) prepare(edit);
    prepared = edit?.origin;
    const wanted = edit?.verdict.state === 'pending' ? `${edit.origin.plan_id} ${edit.number}` : undefined;
    if (wanted === asked) return;
    asked = wanted;
    clearTimeout(timer);
    question?.abort();
    if (!edit || wanted === undefined) return;
    const { signal } = (question = new AbortController());
    const now_ms = performance.now();
    const isQuick = now_ms - changed_ms < quick_ms;
    changed_ms = now_ms;
    if (isQuick) timer = setTimeout(() => void evaluate(edit, signal), pause_ms);
    else untracked(() => void evaluate(edit, signal));
  });
}

/**
 * Evaluates the unchanged route, so that the server has read the data and the first change is evaluated as quickly as
 * later ones. The answer is not used; a failure will show with the first change.
 */
function prepare({ conditions, route }: RouteEdit): void {
  api.evaluateRoute({ ...conditions, route }, new AbortController().signal).catch(() => undefined);
}

async function evaluate(edit: RouteEdit, signal: AbortSignal): Promise<void> {
  let verdict: Verdict;
  try {
    const { evaluation } = await api.evaluateRoute({ ...edit.conditions, route: edit.route }, signal);
    verdict = evaluation.status === 'ok'
      ? { state: 'ok', plan: { ...evaluation, plan_id: edit.origin.plan_id, name: editedName(edit) } }
      : { state: 'infeasible', answer: evaluation };
  } catch (error) {
    if (signal.aborted) return;
    verdict = { state: 'failed', detail: api.wordsOf(error) };
  }
  if (deliver(edit.number, verdict)) announce(spoken(verdict, edit));
}

function spoken(verdict: Verdict, { origin }: RouteEdit): string {
  switch (verdict.state) {
    case 'ok': {
      const more_s = verdict.plan.travel_time_s - origin.travel_time_s;
      const size = duration(Math.abs(more_s));
      const change = size === duration(0) ? 'as planned' : `${size} ${more_s < 0 ? 'less' : 'more'} than planned`;
      return `Travel time ${duration(verdict.plan.travel_time_s)}, ${change}.${warnedOf(verdict.plan)}`;
    }
    case 'infeasible':
      return `The route cannot be flown. ${reasonTitle(verdict.answer.reason)}. ${verdict.answer.explanation}`;
    case 'failed':
      return `The route could not be evaluated. ${verdict.detail}`;
    case 'pending':
      return '';
  }
}

export const editedName = ({ origin }: RouteEdit): string => `${titleOf(origin).replace(/ \(edited\)$/, '')} (edited)`;

/** Stores the edited route, as drawn, as a new plan; returns whether it was stored. */
export async function saveEdit(): Promise<boolean> {
  const edit = routeEdit.value;
  const [from, ...others] = edit?.route ?? [];
  const to = others.pop();
  if (!edit || whyNotSaved(edit) || !from || !to) return false;
  const inputs: PlanInputs = {
    ...edit.conditions, from, to, ...(others.length > 0 ? { via: others } : {}), method: 'direct', refine: false, name: editedName(edit),
  };
  try {
    const { plan } = await api.planNow(inputs);
    if (plan.status !== 'ok') {
      deliver(edit.number, { state: 'infeasible', answer: plan });
      return false;
    }
    rememberRequest(plan.plan_id, inputs);
    closeSavedEdit();
    add({ ...plan, created: plan.created ?? new Date().toISOString() });
    announce(`Stored as ${titleOf(plan)}.`);
    return true;
  } catch (error) {
    deliver(edit.number, { state: 'failed', detail: api.wordsOf(error) });
    return false;
  }
}
