import * as api from './client';
import type { JobStatus } from '../contract/types';

const pollWait_s = 1;

export const isUnderWay = ({ status }: JobStatus): boolean => status === 'accepted' || status === 'running';

/** Follows a job to its end and reports each state; dismisses the job when `signal` is aborted. */
export async function follow(begun: JobStatus, signal: AbortSignal, tell: (status: JobStatus) => void): Promise<JobStatus> {
  let status = begun;
  while (isUnderWay(status)) {
    tell(status);
    if (signal.aborted) return api.dismissJob(status.jobID);
    status = await nextState(status, signal);
  }
  return status;
}

/** The job's next state. Asks at most once a second, even if the server answers without waiting. */
async function nextState(status: JobStatus, signal: AbortSignal): Promise<JobStatus> {
  const asked_ms = Date.now();
  try {
    const next = await api.job(status.jobID, pollWait_s, signal);
    const early_ms = 1000 * pollWait_s - (Date.now() - asked_ms);
    const unchanged = next.updated === status.updated && next.progress === status.progress && next.status === status.status;
    if (unchanged && early_ms > 0) await new Promise((resolve) => setTimeout(resolve, early_ms));
    return next;
  } catch (error) {
    if (signal.aborted) return status;
    throw error;
  }
}
