import type { PlanInputs } from '../../contract/types';

/** The job that this tab waits for. It is kept in the session storage: a reload keeps it, and other tabs do not see it. */
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
    // Without storage the job is only lost from sight when the page is left. Its plan is stored all the same.
  }
}
