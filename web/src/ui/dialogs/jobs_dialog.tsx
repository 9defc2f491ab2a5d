import type { VNode } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { dismissJob, jobs } from '../../actions/client';
import type { JobStatus } from '../../contract/types';
import { outcomeTitle, stageTitle } from '../../model/job';
import { may } from '../../model/login';
import { asSentence } from '../../model/page_words';
import { duration, shortTime } from '../../model/time';
import { Modal } from '../common/modal';

const pause_ms = 1000;

/** The server's present and past jobs, newest first; updated every second while the dialog is open. */
export function JobsDialog(): VNode {
  const [listed, setListed] = useState<JobStatus[] | undefined>(undefined);
  const [fault, setFault] = useState<string | undefined>(undefined);
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    let open = true;
    const look = (): void => {
      jobs()
        .then(({ jobs: now }) => {
          if (!open) return;
          setListed(now);
          setFault(undefined);
        })
        .catch((error: unknown) => {
          if (open) setFault(error instanceof Error ? error.message : String(error));
        })
        .finally(() => {
          if (open) timer = setTimeout(look, pause_ms);
        });
    };
    look();
    return () => {
      open = false;
      clearTimeout(timer);
    };
  }, []);
  return (
    <Modal title="Jobs" guide="jobs" wide>
      {fault && <p class="fault" role="alert">{fault}</p>}
      {!listed && !fault && <p class="quiet">Asking the server …</p>}
      {listed?.length === 0 && <p class="quiet">No jobs yet.</p>}
      {listed && listed.length > 0 && (
        <div class="scroll-box jobs" tabIndex={0} role="region" aria-label="Jobs">
          <table class="figures datasets">
            <thead>
              <tr>
                <th scope="col">Created</th><th scope="col">Process</th><th scope="col">State</th><th scope="col">Took</th>
                <th scope="col"><span class="visually-hidden">Cancel</span></th>
              </tr>
            </thead>
            <tbody>{listed.map((job) => <JobLine key={job.jobID} job={job} />)}</tbody>
          </table>
        </div>
      )}
    </Modal>
  );
}

function JobLine({ job }: { job: JobStatus }): VNode {
  const live = job.status === 'accepted' || job.status === 'running';
  return (
    <tr>
      <td>{shortTime(Date.parse(job.created))}</td>
      <td>{job.processID.replaceAll('-', ' ')}</td>
      <td>
        {live ? `${stageTitle(job)} · ${job.progress} %` : outcomeTitle(job)}
        {live && <progress max={100} value={job.progress} aria-label="Progress" />}
        {!live && job.message && <span class="row-warning">{asSentence(job.message)}</span>}
      </td>
      <td>{tookText(job)}</td>
      <td>{live && may('pilot') && <button type="button" onClick={() => void dismissJob(job.jobID).catch(() => undefined)}>Cancel</button>}</td>
    </tr>
  );
}

function tookText({ started, finished }: JobStatus): string {
  if (!started || !finished) return '–';
  const seconds = (Date.parse(finished) - Date.parse(started)) / 1000;
  return seconds < 60 ? `${Math.round(seconds)} s` : duration(seconds);
}
