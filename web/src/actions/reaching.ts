import { draft, emptyDraft, refuse } from '../model/setup/draft';
import { inputsOf } from '../model/setup/draft_request';
import { conditionsOfReach, hoursIn, reach, reachHours } from '../model/reach';
import { conditionsIn } from '../model/setup/requests';
import { announce } from '../model/screen';
import { ask } from '../model/view';
import * as api from './client';

let question: AbortController | undefined;

/** Computes and shows the isochrones of the set-up from its start for each of the hours. */
export async function showReach(): Promise<void> {
  const hours = hoursIn(reachHours.value);
  const form = inputsOf({ ...draft.value, to: draft.value.from, via: '', goals_file: emptyDraft.goals_file });
  if (!hours) {
    reach.value = { state: 'failed', detail: 'Write the hours as 6, 12, 24.' };
    return;
  }
  if ('faults' in form) {
    refuse({ ...form.faults, to: undefined });
    return;
  }
  hideReach();
  const { signal } = (question = new AbortController());
  reach.value = { state: 'pending' };
  const { from = [0, 0] } = form.inputs;
  try {
    const { reach: answer } = await api.reach({ ...conditionsOfReach(conditionsIn(form.inputs)), from, hours }, signal);
    if (answer.status !== 'ok') {
      reach.value = { state: 'failed', detail: answer.explanation ?? 'Nothing can be reached from there.' };
      return;
    }
    reach.value = { state: 'ok', answer };
    const widest = answer.features.at(-1);
    ask({ do: 'fit', places: widest ? widest.geometry.coordinates.flatMap(([outer]) => outer ?? []) : [from] });
    announce(`Reach shown for ${hours.join(', ')} hours.`);
  } catch (error) {
    if (signal.aborted) return;
    reach.value = { state: 'failed', detail: api.wordsOf(error) };
  }
}

/** Aborts the request and removes the isochrones from the map. */
export function hideReach(): void {
  question?.abort();
  reach.value = undefined;
}
