import { computed, signal } from '@preact/signals';
import type { Infeasible, JobStatus } from '../contract/types';
import { contains } from '../geo/boxes';
import { datasets } from './datasets';
import { asSentence } from './page_words';
import { draft, type Draft } from './setup/draft';

/** The planning job under way, if any. */
export interface RunningJob {
  status: JobStatus | undefined; // undefined while it is being handed in
  started_ms: number;
}

export const running = signal<RunningJob | undefined>(undefined);

/** A change of the set-up that may help, and the words of its button. */
export interface Remedy {
  title: string;
  part: Partial<Draft>;
}

/** Why the last attempt gave no plan. */
export type Failure = { kind: 'infeasible'; answer: Infeasible } | { kind: 'failed'; title: string; detail: string; remedies?: Remedy[] };

export const failure = signal<Failure | undefined>(undefined);

/** The set-up at the last attempt. */
export const attempted = signal<Draft | undefined>(undefined);

/** Whether the set-up differs from that of the last attempt. Then the place and the remedies of its failure may be wrong. */
export const isFailureOld = computed(() => attempted.value !== undefined && JSON.stringify(attempted.value) !== JSON.stringify(draft.value));

const stages: Record<string, string> = {
  'loading data': 'Reading the data',
  search: 'Searching the route',
  environment: 'Preparing the sea',
  refinement: 'Refining the route',
  alternatives: 'Looking for alternatives',
  done: 'Storing the plan',
};

const impossible = 'not possible as asked: ';

/** Why the requested route of a running job is impossible, while the server searches for changes that would help. */
export const causeIn = (status: JobStatus | undefined): string | undefined =>
  status?.stage.startsWith(impossible) ? asSentence(status.stage.slice(impossible.length)) : undefined;

/** The end of a job, for a list; a job that was done may have found that there is no route. */
export const outcomeTitle = ({ status, message }: JobStatus): string =>
  status === 'successful' && message.startsWith('no route') ? 'no route' : status;

/** A job's stage in words. */
export function stageTitle(status: JobStatus | undefined): string {
  if (!status) return 'Handing in the request';
  if (status.status === 'accepted') return 'Waiting for a worker';
  if (causeIn(status)) return 'Not possible as asked. Looking for what would help';
  const stage = status.stage;
  return stages[stage] ?? (stage ? stage.charAt(0).toUpperCase() + stage.slice(1).replaceAll('_', ' ') : 'Working');
}

/** "Searching the route, 45 %.", for screen readers. */
export const progressInWords = (status: JobStatus): string => `${stageTitle(status)}, ${status.progress} %.`;

/** The reason if the currents are too strong, end before the route, or do not cover it. */
const ofCurrents = ['current', 'data_area', 'data_period'];

/** Whether the place of a refusal lies outside the bathymetry, too. */
function lacksDepths({ at, datasets: used }: Infeasible): boolean {
  const bathymetry = used.filter(({ kind }) => kind === 'bathymetry').map(({ id }) => id);
  const boxes = (datasets.value ?? []).filter(({ id }) => bathymetry.includes(id)).map(({ bbox }) => bbox);
  return boxes.length > 0 && !boxes.some((box) => contains(box, [at.lon, at.lat, at.lon, at.lat]));
}

/** Whether there may be a plan without currents. */
export const mayHelpWithoutCurrents = (refusal: Infeasible): boolean =>
  ofCurrents.includes(refusal.binding_constraint ?? '') && !(refusal.binding_constraint === 'data_area' && lacksDepths(refusal));

/** Headline for a reason that a plan could not be made. */
export function reasonTitle(reason: string): string {
  const titles: Record<string, string> = {
    start_on_land: 'The start lies on land',
    start_too_shallow: 'The start is too shallow',
    start_near_iceberg: 'The start is too close to an iceberg',
    goal_on_land: 'The goal lies on land',
    goal_too_shallow: 'The goal is too shallow',
    goal_near_iceberg: 'The goal is too close to an iceberg',
    outside_data: 'Outside the area or time of the data',
    current_too_strong: 'The current is too strong',
    too_shallow: 'The route crosses land or shallow water',
    near_iceberg: 'The route passes too close to an iceberg',
    goal_unreachable: 'Every route to the goal is closed',
    start_in_zone: 'The start lies in a closed area',
    goal_in_zone: 'The goal lies in a closed area',
    in_zone: 'The route breaks the rule of an area',
    under_ice: 'There is no room to pass below the sea ice',
    no_surfacing: 'Too long without a place to surface',
    no_escape: 'No escape route to open water',
    arrival_too_early: 'The latest arrival is too early',
    energy_exceeded: 'The battery does not last',
    too_large: 'The area is too large for this grid',
    cancelled: 'Planning was cancelled',
  };
  return titles[reason] ?? reason.charAt(0).toUpperCase() + reason.slice(1).replaceAll('_', ' ');
}
