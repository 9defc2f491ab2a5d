import type { VNode } from 'preact';
import { refresh } from '../../actions/session';
import { imports } from '../../model/imports';
import { Icon } from '../common/icon';
import { DatasetList } from './dataset_list';
import { RoleNote } from '../common/role_note';
import { FileChooser } from './file_chooser';
import { HandMadePart } from './hand_made_part';
import { ImportCard } from './import_card';

/** The content of the store, and the import of files. */
export function DataPanel(): VNode {
  return (
    <div class="data-panel">
      <FileChooser />
      {imports.value.map((one) => <ImportCard key={one.number} one={one} />)}
      <HandMadePart />
      <div class="setup-head">
        <h2>In the store</h2>
        <button type="button" class="link" onClick={() => void refresh()}><Icon name="refresh" size={13} /> Refresh</button>
      </div>
      <RoleNote role="admin" what="Removing a dataset" />
      <DatasetList />
      <p class="hint">The newest of each kind is used, of depths the finest, unless the set-up names another under <b>Data</b>.</p>
    </div>
  );
}
