import type { VNode } from 'preact';
import { useState } from 'preact/hooks';
import { deleteDataset } from '../../actions/session';
import type { Dataset } from '../../contract/data_types';
import { covered, toggleCoverage } from '../../model/coverage';
import { byHand, connectionFault, damagedDatasets, datasets, isEmptyStore, isInUse } from '../../model/datasets';
import { inWords } from '../../model/ingest_options';
import { may } from '../../model/login';
import { asSentence } from '../../model/page_words';
import { plans } from '../../model/plan/plans';
import { shortTime } from '../../model/time';
import { fileSize } from '../../model/units';
import { ask } from '../../model/view';
import { borderOf } from '../../geo/boxes';
import { Icon, IconButton } from '../common/icon';
import { TrackList } from './track_list';

/** All stored datasets with their times, sizes and messages. */
export function DatasetList(): VNode {
  if (datasets.value === undefined) {
    return <p class="quiet">{connectionFault.value ? 'What the store holds is not known: the server does not answer.' : 'Reading the store …'}</p>;
  }
  if (isEmptyStore.value) return <p class="quiet">Nothing yet.</p>;
  return (
    <>
      {damagedDatasets.value.map(({ id, detail }) => <p key={id} class="fault" role="alert">{id ?? 'A dataset'}: {detail}</p>)}
      <ul class="dataset-list" aria-label="Datasets">
        {datasets.value.map((dataset) => <Row key={dataset.id} dataset={dataset} />)}
      </ul>
    </>
  );
}

const isByHand = ({ id }: Dataset): boolean => id === byHand('icebergs') || id === byHand('zones');

function Row({ dataset }: { dataset: Dataset }): VNode {
  const [fault, setFault] = useState<string | undefined>(undefined);
  const { bbox, file_name, file_size_bytes, id, ingested, kind, name, rows_accepted, rows_refused, stale, time_end, time_start, warnings } = dataset;
  const shown = covered.value.includes(id);
  const inUse = isInUse(dataset);
  const cover = (): void => {
    toggleCoverage(id);
    if (!shown) ask({ do: 'fit', places: borderOf(bbox) });
  };
  const remove = async (): Promise<void> => {
    if (window.confirm(question(dataset))) setFault(await deleteDataset(id));
  };
  return (
    <li id={`dataset-${id}`} tabIndex={-1} class={shown ? 'dataset covered' : 'dataset'}>
      <div class="dataset-head">
        <span class="dataset-kind">{kind}</span>
        {inUse && <span class="badge in-use">in use</span>}
        <IconButton icon={shown ? 'eye' : 'eyeOff'} label={`Show the coverage of ${name}`} pressed={shown} onClick={cover} />
        <IconButton icon="trash" label={`Remove ${name}`} disabled={!may('admin')} onClick={() => void remove()} />
      </div>
      <b class="dataset-name">{name}</b>
      {stale && <p class="caution-box">{asSentence(stale)} <BetterLink id={dataset.better_id} /></p>}
      <p class="dataset-figures">
        {time_start && time_end && <span>{time_start === time_end ? shortTime(Date.parse(time_start)) : `${shortTime(Date.parse(time_start))} – ${shortTime(Date.parse(time_end))}`}</span>}
        {kind === 'icebergs' && <span>{rows_accepted.toLocaleString('en')} {rows_accepted === 1 ? 'sighting' : 'sightings'}{rows_refused > 0 ? `, ${rows_refused.toLocaleString('en')} refused` : ''}</span>}
        {isByHand(dataset) ? null : <span>{file_name}, {fileSize(file_size_bytes)}</span>}
        <span>{isByHand(dataset) ? 'changed' : 'in since'} {shortTime(Date.parse(ingested))}</span>
      </p>
      {kind === 'glider-tracks' && <TrackList dataset={id} name={name} />}
      {warnings.length > 0 && (
        <details class="dataset-warnings">
          <summary><Icon name="warning" size={12} /> {warnings.length === 1 ? '1 message' : `${warnings.length} messages`}</summary>
          <ul class="report-texts">{warnings.map((text) => <li key={text}>{asSentence(inWords(text))}</li>)}</ul>
        </details>
      )}
      {fault && <p class="fault" role="alert">{fault}</p>}
    </li>
  );
}

/** Leads to the dataset in the list that replaces a stale one: the two may have the same name. */
function BetterLink({ id }: { id: string | undefined }): VNode | null {
  if (!id || !datasets.value?.some((other) => other.id === id)) return null;
  const show = (): void => document.getElementById(`dataset-${id}`)?.focus();
  return <button type="button" class="link" onClick={show}>Show it</button>;
}

/** Plans keep their values, but cannot be evaluated again with a deleted dataset. */
function question({ id, name }: Dataset): string {
  const using = plans.value.filter((plan) => plan.datasets.some((used) => used.id === id)).length;
  const consequence = using === 0 ? '' : `\n\n${using === 1 ? 'One plan was' : `${using} plans were`} made on it and cannot be evaluated on it any more.`;
  return `Remove ${name} from the store?${consequence}`;
}
