import { useEffect, useState } from 'preact/hooks';
import type { VNode } from 'preact';
import { downloadAddress, faultsOf, mission, type ExportFormat } from '../../api/client';
import type { MissionPreview, Plan } from '../../api/types';
import { asSentence } from '../../model/page_words';
import { selectedPlan, titleOf } from '../../model/plans';
import { Icon } from '../common/icon';
import { Modal } from '../common/modal';
import { Warnings } from '../waypoints/warnings';

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
  const [file, setFile] = useState(0);

  useEffect(() => {
    if (!valid) return;
    let wanted = true;
    mission(plan.plan_id, number)
      .then((answer) => {
        if (!wanted) return;
        setPreview(answer);
        setFaults([]);
        setFile(0);
      })
      .catch((error: unknown) => {
        if (!wanted) return;
        setPreview(undefined);
        setFaults(faultsOf(error));
      });
    return () => {
      wanted = false;
    };
  }, [plan.plan_id, number, valid]);

  const shown = preview?.files[file];
  return (
    <Modal title={`Export ${titleOf(plan)}`} wide>
      <div class="export-controls">
        <div class={valid ? 'field' : 'field faulty'}>
          <label for="list-number">Number of the waypoint list <span class="unit">0–{last_list}</span></label>
          <input
            id="list-number" type="text" inputMode="numeric" value={numberText} aria-invalid={valid ? undefined : true}
            onInput={(event) => setNumberText(event.currentTarget.value)}
          />
        </div>
        <div class="downloads" role="group" aria-label="Downloads">
          <Download plan={plan} format="zip" number={valid ? number : 10} title="Mission files (.zip)" primary />
          {others.map(([format, title]) => <Download key={format} plan={plan} format={format} number={number} title={title} />)}
        </div>
      </div>
      <Warnings warnings={[...new Set([...(preview?.warnings ?? []), ...plan.warnings])]} />
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
        faults.length === 0 && <p class="quiet">Asking the server for the files …</p>
      )}
      <p class="hint">Not for navigation as it is: check the files before they fly.</p>
    </Modal>
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
  primary?: boolean;
}

function Download({ plan, format, number, title, primary }: DownloadProps): VNode {
  return (
    <a class={primary ? 'button primary' : 'button'} href={downloadAddress(plan.plan_id, format, number)} download="">
      <Icon name="download" /> {title}
    </a>
  );
}
