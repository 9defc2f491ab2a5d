import { signal } from '@preact/signals';
import type { VNode } from 'preact';
import { useRef } from 'preact/hooks';
import { importFiles } from '../../actions/importing';
import { ingestOptions, emptyForm, optionsOf } from '../../model/ingest_options';
import { forbids, may } from '../../model/login';
import { drawer, leftTab } from '../../model/screen';
import { Icon } from '../common/icon';
import { RoleNote } from '../common/role_note';

/** The kind of the files chosen next; empty: recognised from the file. */
const kind = signal('');

/** Sends files and shows the results. */
export function take(files: FileList | null): void {
  if (!files || files.length === 0 || forbids('pilot', 'Adding data')) return;
  leftTab.value = 'data';
  drawer.value = 'left';
  const stated = optionsOf({ ...emptyForm, kind: kind.value });
  if ('options' in stated) void importFiles([...files], stated.options);
}

/** A button that opens the file chooser; files can also be dropped anywhere on the page. */
export function FileChooser(): VNode {
  const input = useRef<HTMLInputElement>(null);
  if (!may('pilot')) return <RoleNote role="pilot" what="Adding data" />;
  return (
    <div class="file-chooser">
      <div class="field-row">
        <button type="button" onClick={() => input.current?.click()}><Icon name="upload" /> Add files …</button>
        <select aria-label="Take the files as" value={kind.value} onChange={(event) => { kind.value = event.currentTarget.value; }}>
          <option value="">as recognised</option>
          {ingestOptions.kind.choices?.map(([value, title]) => <option key={value} value={value}>as {title}</option>)}
        </select>
      </div>
      <p class="hint">Or drop them anywhere on the page. Files of one dataset go together.</p>
      <input
        ref={input} type="file" multiple hidden aria-label="Files to add"
        onChange={(event) => {
          take(event.currentTarget.files);
          event.currentTarget.value = '';
        }}
      />
    </div>
  );
}
