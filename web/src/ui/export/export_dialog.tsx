import { useEffect, useState } from 'preact/hooks';
import type { VNode } from 'preact';
import { dangersIn, downloadAddress, faultsOf, mission, type ExportFormat } from '../../api/client';
import type { Message, MissionPreview, Plan } from '../../api/types';
import { listRows } from '../../model/list_rows';
import { bareMessage, countOf, messagesOf } from '../../model/messages';
import { asSentence } from '../../model/page_words';
import { selectedPlan, titleOf } from '../../model/plans';
import { none } from '../../model/units';
import { Icon } from '../common/icon';
import { MessageList, Messages } from '../common/messages';
import { Modal } from '../common/modal';

const others: [ExportFormat, string][] = [
  ['gpx', 'GPX'], ['kml', 'KML'], ['geojson', 'GeoJSON'], ['csv', 'CSV'], ['pdf', 'Brief (PDF)'],
];

/** The numbers above it belong to the vehicle's firmware. */
const last_list = 97;

/** The mission files as the server would write them, and the downloads. */
export function ExportDialog(): VNode | null {
  const plan = selectedPlan.value;
  return plan ? <Export plan={plan} /> : null;
}

function Export({ plan }: { plan: Plan }): VNode {
  const [numberText, setNumberText] = useState('10');
  const number = Number(numberText);
  const valid = Number.isInteger(number) && number >= 0 && number <= last_list;
  const [preview, setPreview] = useState<MissionPreview | undefined>(undefined);
  const [faults, setFaults] = useState<string[]>([]);
  const [dangers, setDangers] = useState<string[]>([]);
  const [accepted, setAccepted] = useState(false);
  const [file, setFile] = useState(0);

  useEffect(() => {
    if (!valid) return;
    let wanted = true;
    mission(plan.plan_id, number, accepted)
      .then((answer) => {
        if (!wanted) return;
        setPreview(answer);
        setFaults([]);
        setFile(0);
      })
      .catch((error: unknown) => {
        if (!wanted) return;
        setPreview(undefined);
        const found = dangersIn(error);
        if (found.length > 0) setDangers(found);
        setFaults(found.length > 0 ? [] : faultsOf(error));
      });
    return () => {
      wanted = false;
    };
  }, [plan.plan_id, number, valid, accepted]);

  const shown = preview?.files[file];
  const closed = dangers.length > 0 && !accepted;
  const told = [...new Map([...(preview ? messagesOf(preview) : []), ...messagesOf(plan)].map((message) => [message.text, message])).values()];
  return (
    <Modal title={`Export ${titleOf(plan)}`} guide="export" wide>
      <div class="export-controls">
        <div class={valid ? 'field' : 'field faulty'}>
          <label for="list-number">Number of the waypoint list <span class="unit">0–{last_list}</span></label>
          <input
            id="list-number" type="text" inputMode="numeric" value={numberText} aria-invalid={valid ? undefined : true}
            onInput={(event) => setNumberText(event.currentTarget.value)}
          />
        </div>
        <div class="downloads" role="group" aria-label="Downloads">
          <Download plan={plan} format="zip" number={valid ? number : 10} title="Mission files (.zip)" accepted={accepted} closed={closed} primary />
          {others.map(([format, title]) => <Download key={format} plan={plan} format={format} number={number} title={title} accepted={accepted} closed={closed} />)}
        </div>
      </div>
      <Dangers dangers={dangers.map((text) => told.find((message) => message.text === text) ?? bareMessage('danger', text))} accepted={accepted} accept={setAccepted} />
      <Messages of={{ messages: told.filter(({ text }) => !dangers.includes(text)), warnings: [] }} />
      <Refusal faults={faults} />
      {preview && preview.files.length > 1 && (
        <div class="file-tabs" role="group" aria-label="Files">
          {preview.files.map(({ name }, i) => (
            <button type="button" key={name} aria-pressed={i === file} onClick={() => setFile(i)}>{name}</button>
          ))}
        </div>
      )}
      {shown ? (
        <figure class="preview">
          <figcaption>{shown.name}</figcaption>
          <pre tabIndex={0} aria-label={`Text of ${shown.name}`}>{shown.text}</pre>
        </figure>
      ) : (
        faults.length === 0 && !closed && <p class="quiet">Asking the server for the files …</p>
      )}
      {preview && <Rows preview={preview} />}
      <p class="hint">Not for navigation as it is: check the files before they fly.</p>
    </Modal>
  );
}

/** What the pilot has to confirm before any file is handed out. */
function Dangers({ dangers, accepted, accept }: { dangers: Message[]; accepted: boolean; accept: (yes: boolean) => void }): VNode | null {
  if (dangers.length === 0) return null;
  return (
    <section class="danger-box" aria-label="Dangers">
      <h3><Icon name="warning" /> {countOf(dangers.length, 'danger')}</h3>
      <MessageList messages={dangers} />
      <label class="tick">
        <input type="checkbox" checked={accepted} onChange={(event) => accept(event.currentTarget.checked)} /> I have read this; export all the same
      </label>
    </section>
  );
}

/** Which row of which file a waypoint is. */
function Rows({ preview }: { preview: MissionPreview }): VNode | null {
  const rows = listRows(preview.files);
  if (rows.length === 0) return null;
  return (
    <details class="list-rows">
      <summary>Waypoints and rows of the files</summary>
      <div class="scroll-box" tabIndex={0} role="region" aria-label="Rows of the files">
        <table class="figures">
          <thead><tr><th scope="col">Waypoint</th><th scope="col">JSON index</th><th scope="col">File</th><th scope="col">Row</th></tr></thead>
          <tbody>
            {rows.map(({ label, index, file, row }) => (
              <tr key={index}><th scope="row">{label}</th><td>{index}</td><td>{file || none}</td><td>{row ?? none}</td></tr>
            ))}
          </tbody>
        </table>
      </div>
    </details>
  );
}

/** Why the server writes no mission files of the plan: the other downloads are only its route. */
function Refusal({ faults }: { faults: string[] }): VNode | null {
  if (faults.length === 0) return null;
  return (
    <section class="fault" role="alert">
      <h3>No mission files are written</h3>
      <ul>{faults.map((text) => <li key={text}>{asSentence(text)}</li>)}</ul>
    </section>
  );
}

interface DownloadProps {
  plan: Plan;
  format: ExportFormat;
  number: number;
  title: string;
  accepted: boolean;
  closed: boolean; // dangers are not confirmed yet
  primary?: boolean;
}

function Download({ plan, format, number, title, accepted, closed, primary }: DownloadProps): VNode {
  if (closed) return <button type="button" class={primary ? 'primary' : undefined} disabled><Icon name="download" /> {title}</button>;
  return (
    <a class={primary ? 'button primary' : 'button'} href={downloadAddress(plan.plan_id, format, number, accepted)} download="">
      <Icon name="download" /> {title}
    </a>
  );
}
