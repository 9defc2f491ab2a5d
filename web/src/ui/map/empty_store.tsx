import type { VNode } from 'preact';
import { refresh } from '../../actions/session';
import { connectionFault, datasets, isEmptyStore } from '../../model/datasets';
import { locked } from '../../model/login';
import { dialog } from '../../model/screen';
import { silence } from '../../actions/http';
import { Icon } from '../common/icon';
import { FileChooser } from '../data/file_chooser';

/** Instructions if there are no data for planning, or the server cannot be reached. */
export function EmptyStore(): VNode | null {
  const again = (
    <button type="button" onClick={() => void refresh()}>
      <Icon name="refresh" /> Refresh
    </button>
  );
  if (locked.value && datasets.value === undefined) {
    return (
      <section class="empty-store" aria-label="Not signed in">
        <h2>Not signed in</h2>
        <p>The server shows its store to those who have a token.</p>
        <button type="button" class="primary" onClick={() => { dialog.value = 'login'; }}>Sign in</button>
      </section>
    );
  }
  if (connectionFault.value) {
    return (
      <section class="empty-store" role="alert">
        <h2>The server does not answer</h2>
        <p>{connectionFault.value === silence.detail ? 'It may be stopped, or this computer cannot reach it. What you typed stays here.' : connectionFault.value}</p>
        {again}
      </section>
    );
  }
  if (datasets.value === undefined) return <p class="map-note only-narrow" role="status">Waiting for the server …</p>;
  if (!isEmptyStore.value) return null;
  return (
    <section class="empty-store" aria-label="Empty store">
      <h2>The store is empty</h2>
      <p>Plans use depths and currents. A coastline, sea ice and icebergs make them safer.</p>
      <FileChooser />
      <p>Demonstration data are written by <code>floeplan demo FOLDER</code> on the machine that runs Floeplan.</p>
      {again}
    </section>
  );
}
