import type { PlanInputs } from '../api/types';

/** The job that this tab waits for, kept where a reload of the page does not lose it and other tabs do not see it. */
export interface Unfinished {
  job_id: string;
  inputs: PlanInputs;
  started_ms: number;
}

const key = 'floeplan.unfinished';

export function unfinished(): Unfinished | undefined {
  try {
    const read = JSON.parse(sessionStorage.getItem(key) ?? 'null') as Partial<Unfinished> | null;
    const { job_id, inputs, started_ms } = read ?? {};
    return job_id !== undefined && inputs !== undefined && started_ms !== undefined ? { job_id, inputs, started_ms } : undefined;
  } catch {
    return undefined;
  }
}

export function keepUnfinished(job: Unfinished | undefined): void {
  try {
    if (job) sessionStorage.setItem(key, JSON.stringify(job));
    else sessionStorage.removeItem(key);
  } catch {
    // A browser that refuses storage only loses the job from sight when the page is left; its plan is stored all the same.
  }
}
