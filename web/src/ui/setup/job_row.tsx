import type { VNode } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { cancelPlanning } from '../../actions/planning';
import { causeIn, stageTitle, type RunningJob } from '../../model/job';
import { duration } from '../../model/time';
import { Icon } from '../common/icon';

/** The job under way: its stage, percentage and running time, and a button that cancels it. */
export function JobRow({ job }: { job: RunningJob }): VNode {
  const [now_ms, setNow] = useState(Date.now());
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 500);
    return () => clearInterval(timer);
  }, []);
  const percent = job.status?.progress ?? 0;
  const cause = causeIn(job.status);
  const elapsed_s = Math.max(0, Math.floor((now_ms - job.started_ms) / 1000));
  return (
    <div class="job" role="group" aria-label="Planning">
      <div class="job-line">
        <span class="job-stage">{stageTitle(job.status)}</span>
        <span class="job-figures">
          {percent} % · {elapsed_s < 60 ? `${elapsed_s} s` : duration(elapsed_s)}
        </span>
      </div>
      {cause && <p class="job-cause" role="status"><Icon name="warning" size={14} /> {cause}</p>}
      <progress max={100} value={percent} aria-label="Progress of planning" />
      <button type="button" onClick={cancelPlanning}>Cancel</button>
    </div>
  );
}
