import { setTime } from '../model/clock';
import { departureRemedies } from '../model/setup/departure_remedies';
import { draft, edit, faults, generalFaults, refuse, type Draft } from '../model/setup/draft';
import { editFor, sortViolations } from '../model/setup/draft_answer';
import { inputsOf } from '../model/setup/draft_request';
import { whyNotPlanned } from '../model/drawing';
import { attempted, failure, progressInWords, reasonTitle, running } from '../model/job';
import { warnedOf } from '../model/messages';
import { forbids } from '../model/login';
import { asSentence } from '../model/page_words';
import { add, nextName, routeOf } from '../model/plan/plans';
import { conditionsOf, rememberRequest, requestOf, withDeparture } from '../model/setup/requests';
import { announce, drawer, leftTab, rightTab, tell } from '../model/screen';
import { duration } from '../model/time';
import { keepUnfinished, unfinished } from '../model/setup/unfinished';
import { ask } from '../model/view';
import * as api from './client';
import { withoutDeleted } from './deleting';
import { follow } from './following';
import { learnRequest } from './plan_inputs';
import type { Position } from '../contract/data_types';
import type { Change, JobStatus, Plan, PlanInputs } from '../contract/types';

let cancelled: AbortController | undefined;

/** Sends the draft, follows its job and shows the result. */
export async function plan(): Promise<void> {
  if (running.value || forbids('pilot', 'Planning')) return;
  const why = whyNotPlanned.value;
  if (why) {
    tell(why);
    return;
  }
  const form = inputsOf(draft.value);
  generalFaults.value = [];
  if ('faults' in form) {
    refuse(form.faults);
    announce('The set-up has faults. Each is shown beside its field.');
    return;
  }
  faults.value = {};
  await planFor(form.inputs);
}

/** Plans again with another departure and otherwise the same inputs. */
export async function planAt(planned: Plan, departure: string): Promise<void> {
  await learnRequest(planned.plan_id);
  await planFor(withDeparture(requestOf(planned.plan_id) ?? guessedRequest(planned), departure));
}

/** Assumed inputs of a plan, if the server does not have them. */
function guessedRequest(planned: Plan): PlanInputs {
  const places = routeOf(planned);
  const [from = [0, 0], to = [0, 0]] = [places[0], places.at(-1)] as [Position?, Position?];
  return { ...conditionsOf(planned).conditions, from, to };
}

async function planFor(inputs: PlanInputs): Promise<void> {
  if (running.value) return;
  failure.value = undefined;
  const named = { ...inputs, name: inputs.name ?? nextName() };
  await attend(named, Date.now(), () => api.submitPlan(named));
}

/** Continues to follow the job that this tab waited for when its page was left. Call after the store was read. */
export async function resumePlanning(): Promise<void> {
  const left = unfinished();
  if (!left || running.value) return;
  await attend(left.inputs, left.started_ms, () => api.job(left.job_id, 0, new AbortController().signal), true);
}

const isUnknown = (error: unknown): boolean => error instanceof api.ApiError && error.problem.status === 404;
const isSilence = (error: unknown): boolean => error instanceof api.ApiError && error.problem.status === 0;

/** Follows a job to its end. A resumed job that the server no longer knows is dropped without a message. */
async function attend(inputs: PlanInputs, started_ms: number, begin: () => Promise<JobStatus>, isLeft = false): Promise<void> {
  running.value = { status: undefined, started_ms };
  attempted.value = draft.peek();
  announce('Planning has begun.');
  cancelled = new AbortController();
  try {
    const begun = await begin();
    keepUnfinished({ job_id: begun.jobID, inputs, started_ms });
    await carryOut(begun, inputs, started_ms, cancelled.signal);
    keepUnfinished(undefined);
  } catch (error) {
    // A missing answer may be temporary or caused by leaving the page: the job is asked for again when the page is opened.
    if (!isSilence(error)) keepUnfinished(undefined);
    if (!cancelled.signal.aborted && !(isLeft && isUnknown(error))) showRefusal(error);
  } finally {
    running.value = undefined;
  }
}

/** Applies a change proposed by the server and plans again. */
export async function planWithChange(change: Change): Promise<void> {
  const part = editFor(change, draft.value);
  if (part) await planWith(part);
}

/** Changes the set-up and plans again; undo restores what was changed. */
export async function planWith(part: Partial<Draft>): Promise<void> {
  edit(part);
  await plan();
}

/** Time between two announcements of progress, so that a screen reader can be used meanwhile. */
const quiet_ms = 10_000;

async function carryOut(begun: JobStatus, inputs: PlanInputs, started_ms: number, signal: AbortSignal): Promise<void> {
  let spoken_ms = Date.now();
  const status = await follow(begun, signal, (now) => {
    running.value = { status: now, started_ms };
    if (Date.now() - spoken_ms < quiet_ms) return;
    spoken_ms = Date.now();
    announce(progressInWords(now));
  });
  if (status.status === 'dismissed') {
    announce('Planning was cancelled.');
    return;
  }
  if (status.status === 'failed') {
    const detail = asSentence(status.message || 'The server gave no reason.');
    failure.value = { kind: 'failed', title: 'Planning failed', detail, remedies: departureRemedies(inputs) };
    announce(`Planning failed. ${detail}`);
    return;
  }
  const { plan: answer } = await api.jobResults(status.jobID);
  if (answer.status === 'ok') {
    rememberRequest(answer.plan_id, inputs);
    showPlan(answer, await alternativesOf(answer));
  } else {
    failure.value = { kind: 'infeasible', answer };
    ask({ do: 'fit', places: [[answer.at.lon, answer.at.lat], inputs.from, inputs.to].filter((place) => place !== undefined) as Position[] });
    announce(`No plan: ${reasonTitle(answer.reason)}. ${answer.explanation}`);
  }
}

/** The stored plans of the alternatives, without those deleted meanwhile. */
async function alternativesOf({ alternatives = [] }: Plan): Promise<Plan[]> {
  const asked = await Promise.allSettled(alternatives.map(({ plan_id }) => api.plan(plan_id)));
  return withoutDeleted(asked.flatMap((answer) => (answer.status === 'fulfilled' ? [answer.value.properties] : [])));
}

function showPlan(answer: Plan, alternatives: Plan[]): void {
  if (answer.departures) rightTab.value = 'departures';
  add({ ...answer, created: answer.created ?? new Date().toISOString() }, alternatives);
  drawer.value = undefined; // on a narrow screen the drawer covers the map
  setTime(Date.parse(answer.departure));
  ask({ do: 'fit', places: [answer, ...alternatives].flatMap(routeOf) });
  const beside = alternatives.length === 0 ? '' : ` ${alternatives.length} alternative${alternatives.length === 1 ? '' : 's'}.`;
  announce(`Plan ready: ${duration(answer.travel_time_s)}, ${answer.waypoints.length} waypoints.${beside}${warnedOf(answer)}`);
}

function showRefusal(error: unknown): void {
  if (error instanceof api.ApiError) {
    const { problem } = error;
    const sorted = sortViolations(problem.errors ?? []);
    refuse(sorted.faults, sorted.general);
    leftTab.value = 'setup';
    const only = Object.keys(sorted.faults).length === 0 && sorted.general.length === 0;
    if (only) failure.value = { kind: 'failed', title: problem.title || 'The server refused', detail: problem.detail };
    announce(`The server refused the request. ${problem.detail}`);
    return;
  }
  failure.value = { kind: 'failed', title: 'Planning failed', detail: String(error) };
}

/** Cancels the running job. */
export function cancelPlanning(): void {
  cancelled?.abort();
}
