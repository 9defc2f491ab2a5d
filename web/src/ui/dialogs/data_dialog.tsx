import type { VNode } from 'preact';
import { refresh } from '../../api/session';
import { datasets } from '../../model/datasets';
import { shortTime } from '../../model/time';
import { Icon } from '../common/icon';
import { Modal } from '../common/modal';

/** All datasets of the store with their times, sizes and warnings. */
export function DataDialog(): VNode {
  return (
    <Modal title="Data in the store" wide>
      <div class="scroll-box" tabIndex={0} role="region" aria-label="Datasets">
        <table class="figures datasets">
          <thead>
            <tr>
              <th scope="col">Kind</th><th scope="col">Name</th><th scope="col">From</th><th scope="col">To</th>
              <th scope="col">Read in</th><th scope="col">Rows</th><th scope="col">File</th>
            </tr>
          </thead>
          <tbody>
            {(datasets.value ?? []).map((dataset) => (
              <tr key={dataset.id}>
                <td>{dataset.kind}</td>
                <td>
                  {dataset.name}
                  {dataset.warnings.map((text) => <span class="row-warning" key={text}><Icon name="warning" size={12} /> {text}</span>)}
                </td>
                <td>{dataset.time_start ? shortTime(Date.parse(dataset.time_start)) : '–'}</td>
                <td>{dataset.time_end ? shortTime(Date.parse(dataset.time_end)) : '–'}</td>
                <td>{shortTime(Date.parse(dataset.ingested))}</td>
                <td>
                  {dataset.kind === 'icebergs' ? dataset.rows_accepted.toLocaleString('en') : '–'}
                  {dataset.rows_refused > 0 && <span class="difference">{dataset.rows_refused} refused</span>}
                </td>
                <td>{dataset.file_name}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <p class="hint">The newest of each kind is used unless another is chosen under Advanced. New files come in with <code>floeplan ingest FILE</code>.</p>
      <button type="button" onClick={() => void refresh()}><Icon name="refresh" /> Look again</button>
    </Modal>
  );
}
