import { signal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import type { VNode } from 'preact';
import { dangersIn, downloadAddress, faultsOf, mission, type ExportFormat } from '../../actions/client';
import { saveFile } from '../../actions/saving';
import type { Message, MissionPreview, Plan } from '../../contract/types';
import { exportLabels } from '../../model/plan/export_labels';
import { exportLabelOf, exportOptions, exportOptionsOf, exportWish, lastList, type ExportOptions, type ExportQuery, type ExportWish } from '../../model/plan/export_options';
import { listRows } from '../../model/plan/list_rows';
import { bareMessage, countOf, messagesOf } from '../../model/messages';
import { asSentence } from '../../model/page_words';
import { selectedPlan, titleOf } from '../../model/plan/plans';
import { dialog } from '../../model/screen';
import { none } from '../../model/units';
import { tool } from '../../model/view';
import { Icon } from '../common/icon';
import { MessageList, Messages } from '../common/messages';
import { Modal } from '../common/modal';
import { ListDifference } from './list_difference';

const others: [ExportFormat, string][] = [
  ['gpx', 'GPX'], ['kml', 'KML'], ['geojson', 'GeoJSON'], ['csv', 'CSV'], ['nmea', 'NMEA'], ['imc', 'IMC'],
  ['targets', 'Seaglider targets'], ['html', 'Brief (HTML)'], ['pdf', 'Brief (PDF)'],
];

/**
 * The plan and its dangers that the pilot has confirmed. The dialog closes while a safe place is picked on the map, and then does not ask for the
 * same confirmation again.
 */
const confirmed = signal<string | undefined>(undefined);

/** A preview of the mission files that the server would write, and the downloads. */
export function ExportDialog(): VNode | null {
  const plan = selectedPlan.value;
  return plan ? <Export plan={plan} /> : null;
}

function Export({ plan }: { plan: Plan }): VNode {
  const options = exportOptionsOf(plan.plan_id);
  const wish = exportWish(options);
  const valid = Object.keys(wish.faults).length === 0;
  const [asked, askNow] = useSettled(JSON.stringify(wish.query));
  const [preview, setPreview] = useState<MissionPreview | undefined>(undefined);
  const [faults, setFaults] = useState<string[]>([]);
  const [dangers, setDangers] = useState<string[]>([]);
  const asConfirmed = `${plan.plan_id} ${JSON.stringify(dangers)}`;
  const accepted = dangers.length > 0 && confirmed.value === asConfirmed;
  const [file, setFile] = useState(0);
  const [refused, setRefused] = useState<{ title: string; texts: string[] }>({ title: '', texts: [] });

  useEffect(() => {
    if (!valid) return;
    let wanted = true;
    mission(plan.plan_id, JSON.parse(asked) as ExportQuery, accepted)
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
        setFaults(found.length > 0 ? [] : faultsOf(error, exportLabelOf));
      });
    return () => {
      wanted = false;
    };
  }, [plan.plan_id, asked, valid, accepted]);

  const refuse = (title: string, texts: string[]): void => setRefused({ title, texts });
  const shown = preview?.files[file];
  const closed = dangers.length > 0 && !accepted;
  const told = toldAtExport(plan, preview);
  return (
    <Modal title={`Export ${titleOf(plan)}`} guide="export" wide>
      <div class="export-controls" onChange={askNow}>
        <Options options={options} faults={wish.faults} change={(part) => { exportOptions.value = { plan_id: plan.plan_id, options: { ...options, ...part } }; }} />
        <div class="downloads" role="group" aria-label="Downloads">
          <Download plan={plan} format="zip" query={{ ...wish.query, ...wish.folder }} title="Mission files (.zip)" accepted={accepted} closed={closed || !valid || faults.length > 0} refuse={refuse} primary />
          {others.map(([format, title]) => <Download key={format} plan={plan} format={format} query={{}} title={title} accepted={accepted} closed={closed} refuse={refuse} />)}
        </div>
      </div>
      <Refusal title={`${refused.title}: no file is written`} faults={refused.texts} />
      <Dangers dangers={dangers.map((text) => told.find((message) => message.text === text) ?? bareMessage('danger', text))} accepted={accepted} accept={(now) => { confirmed.value = now ? asConfirmed : undefined; }} />
      <Messages of={{ messages: told.filter(({ text }) => !dangers.includes(text)), warnings: [] }} />
      <Refusal title="No mission files are written" faults={faults} />
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
      {shown && <ListDifference file={shown} plan={plan} query={wish.query} />}
      {preview && <Rows preview={preview} />}
      <p class="hint">Not for navigation without a check. Check the files before the vehicle flies them.</p>
    </Modal>
  );
}

/** How long a text stays as it is before the server is asked. */
const settled_ms = 300;

/** The text after it has stayed the same for a moment. The function returns it at once. */
function useSettled(text: string): [string, () => void] {
  const [settled, setSettled] = useState(text);
  useEffect(() => {
    const timer = setTimeout(() => setSettled(text), settled_ms);
    return () => clearTimeout(timer);
  }, [text]);
  return [settled, () => setSettled(text)];
}

/** The messages to show at an export. A message about the newest data replaces the message with the same code from when the plan was made. */
function toldAtExport(plan: Plan, preview: MissionPreview | undefined): Message[] {
  const newest = preview ? messagesOf(preview) : [];
  const codes = new Set(newest.map(({ code }) => code).filter((code) => code !== ''));
  const earlier = messagesOf(plan).filter(({ code }) => !codes.has(code));
  return [...new Map([...newest, ...earlier].map((message) => [message.text, message])).values()];
}

interface OptionsProps {
  options: ExportOptions;
  faults: ExportWish['faults'];
  change: (part: Partial<ExportOptions>) => void;
}

/** The choice of files, and their options. */
function Options({ options, faults, change }: OptionsProps): VNode {
  const text = (name: Exclude<keyof ExportOptions, 'set' | 'safe'>, unit: string, placeholder = ''): VNode => {
    const fault = faults[name];
    return (
      <div class={fault ? 'field faulty' : 'field'}>
        <label for={`export-${name}`}>{exportLabels[name]} <span class="unit">{unit}</span></label>
        <input
          id={`export-${name}`} type="text" value={options[name]} placeholder={placeholder} autocomplete="off" spellcheck={false}
          aria-invalid={fault ? true : undefined} aria-describedby={fault ? `export-fault-${name}` : undefined}
          onInput={(event) => change({ [name]: event.currentTarget.value })}
        />
        {fault && <p class="fault" id={`export-fault-${name}`}>{asSentence(fault)}</p>}
      </div>
    );
  };
  return (
    <div class="export-options">
      <div class="field">
        <label for="export-set">{exportLabels.set}</label>
        <select id="export-set" value={options.set} onChange={(event) => change({ set: event.currentTarget.value as ExportOptions['set'] })}>
          <option value="lists">Slocum: waypoint lists alone</option>
          <option value="full">Slocum: full mission with yo and surfacings</option>
          <option value="seaglider">Seaglider: targets, cmdfile, science</option>
        </select>
      </div>
      {options.set !== 'seaglider' && text('number', `0–${lastList}`)}
      {options.set === 'full' && text('mission', '1–8 letters or digits', 'plan')}
      {options.set === 'full' && text('firmware', '', '10.5')}
      {options.set === 'seaglider' && text('science', 'depth:seconds:sensors:gc; …', '20:5:1110:60')}
      {text('glider', 'folder in the archive')}
      {options.set === 'full' && (
        <div class={faults.safe ? 'field faulty' : 'field'}>
          <label for="export-safe">{exportLabels.safe} <span class="unit">one a line</span></label>
          <textarea
            id="export-safe" rows={2} value={options.safe} placeholder="69°12.0′N 53°12.0′W" spellcheck={false}
            aria-invalid={faults.safe ? true : undefined} aria-describedby={faults.safe ? 'export-fault-safe' : undefined}
            onInput={(event) => change({ safe: event.currentTarget.value })}
          />
          {faults.safe && <p class="fault" id="export-fault-safe">{faults.safe}</p>}
          <button
            type="button"
            onClick={() => {
              dialog.value = undefined;
              tool.value = 'safe';
            }}
          >
            <Icon name="crosshair" /> Pick a safe place on the map
          </button>
        </div>
      )}
      {options.set === 'full' && text('iceberg_depth_m', 'm')}
    </div>
  );
}

/** The dangers that the pilot has to confirm before the server returns files. */
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

/** A table of the rows of each waypoint in each file. */
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
            {rows.map(({ label, index, file, row, holds }) => (
              <tr key={`${index} ${file}`}><th scope="row">{label}</th><td>{index}</td><td>{file || none}</td><td>{holds ? 'hold' : row ?? none}</td></tr>
            ))}
          </tbody>
        </table>
      </div>
    </details>
  );
}

/** Why the server does not write files of the plan. */
function Refusal({ title, faults }: { title: string; faults: string[] }): VNode | null {
  if (faults.length === 0) return null;
  return (
    <section class="fault" role="alert">
      <h3>{title}</h3>
      <ul>{faults.map((text) => <li key={text}>{asSentence(text)}</li>)}</ul>
    </section>
  );
}

interface DownloadProps {
  plan: Plan;
  format: ExportFormat;
  query: ExportQuery;
  title: string;
  accepted: boolean;
  closed: boolean; // dangers are not confirmed yet, or an option is wrong
  refuse: (title: string, faults: string[]) => void; // called with the reasons why the server does not write the file; none if it does
  primary?: boolean;
}

function Download({ plan, format, query, title, accepted, closed, refuse, primary }: DownloadProps): VNode {
  const save = async (event: MouseEvent & { currentTarget: HTMLAnchorElement }): Promise<void> => {
    event.preventDefault();
    refuse(title, []);
    try {
      await saveFile(event.currentTarget.href);
    } catch (error) {
      refuse(title, faultsOf(error, exportLabelOf));
    }
  };
  if (closed) return <button type="button" class={primary ? 'primary' : undefined} disabled><Icon name="download" /> {title}</button>;
  return (
    <a class={primary ? 'button primary' : 'button'} href={downloadAddress(plan.plan_id, format, query, accepted)} download="" onClick={(event) => void save(event)}>
      <Icon name="download" /> {title}
    </a>
  );
}
