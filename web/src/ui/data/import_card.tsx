import type { VNode } from 'preact';
import { cancelImport, dismissImport, maySendAgain, sendAgain } from '../../actions/importing';
import { isLive, type Import, type SentFile } from '../../model/imports';
import { stageTitle } from '../../model/job';
import { fileSize } from '../../model/units';
import { Icon, IconButton } from '../common/icon';
import { Report } from './report';

/** Imports with the progress of each file and, at the end, its result. */
export function ImportCard({ one }: { one: Import }): VNode {
  const { files, state, number } = one;
  const title = files.length === 1 ? (files[0]?.name ?? '') : `${files.length} files`;
  return (
    <section class="import-card" aria-label={`Import of ${title}`} aria-busy={isLive(one)}>
      <div class="import-head">
        <h2>{title}</h2>
        {isLive(one)
          ? <button type="button" onClick={() => cancelImport(number)}>Cancel</button>
          : <IconButton icon="x" label={`Dismiss the import of ${title}`} onClick={() => dismissImport(number)} />}
      </div>
      {state.stage === 'sending' && <ul>{files.map((file) => <FileRow key={file.name} file={file} />)}</ul>}
      {state.stage !== 'sending' && <ul>{files.filter(({ stage }) => stage === 'failed').map((file) => <FileRow key={file.name} file={file} />)}</ul>}
      {state.stage === 'reading' && (
        <div role="status">
          <p class="job-line"><span>{stageTitle(state.job)}</span><span class="job-figures">{state.job?.progress ?? 0} %</span></p>
          <progress max={100} value={state.job?.progress ?? 0} aria-label="Reading" />
        </div>
      )}
      {state.stage === 'failed' && <p class="fault" role="alert">{state.detail}</p>}
      {maySendAgain(one) && <button type="button" onClick={() => void sendAgain(number)}><Icon name="upload" /> Send again</button>}
      {state.stage === 'cancelled' && <p class="quiet">Cancelled; nothing was stored.</p>}
      {state.stage === 'done' && state.reports.map((report, i) => (
        <Report key={`${report.file} ${i} ${report.status}`} report={report} number={number} />
      ))}
    </section>
  );
}

const stages = { waiting: 'waiting', checking: 'checking', sending: 'sending', sent: 'sent', read: 'read', failed: 'not sent' } as const;

function FileRow({ file: { name, size, stage, bytes, fault } }: { file: SentFile }): VNode {
  const percent = size > 0 ? Math.floor((100 * bytes) / size) : 100;
  const moving = stage === 'checking' || stage === 'sending';
  return (
    <li class="sent-file">
      <p class="job-line">
        <span class="file-name">{stage === 'failed' && <Icon name="warning" size={12} />} {name}</span>
        <span class="job-figures">{stages[stage]}{moving ? ` ${percent} %` : ` · ${fileSize(size)}`}</span>
      </p>
      {moving && <progress max={100} value={percent} aria-label={`${name}, ${stages[stage]}`} />}
      {fault && <p class="fault" role="alert">{fault}</p>}
    </li>
  );
}
