import type { VNode } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { mission, wordsOf } from '../../actions/client';
import type { MissionPreview, Plan } from '../../contract/types';
import type { ExportQuery } from '../../model/plan/export_options';
import { textOf } from '../../model/file_text';
import { differenceOf } from '../../model/plan/list_difference';
import { plans, titleOf } from '../../model/plan/plans';
import { Icon } from '../common/icon';

type MissionFile = MissionPreview['files'][number];

/** The file for the comparison. */
type Other = { plan_id: string } | { file: MissionFile };

const signs = { both: ' ', other: '−', this: '+' } as const;

/** Shows the differences of the file to that of another plan, or to one that the vehicle has on board. */
export function ListDifference({ file, plan, query }: { file: MissionFile; plan: Plan; query: ExportQuery }): VNode {
  const [other, setOther] = useState<Other | undefined>(undefined);
  const [beside, setBeside] = useState<{ file?: MissionFile; fault?: string } | undefined>(undefined);
  const chooser = useRef<HTMLInputElement>(null);
  const planId = other && 'plan_id' in other ? other.plan_id : undefined;
  const asked = JSON.stringify(query);

  useEffect(() => {
    setBeside(undefined);
    if (other && 'file' in other) setBeside({ file: other.file });
    if (planId === undefined) return;
    let wanted = true;
    void mission(planId, query, true)
      .then(({ files }) => files.find(({ name }) => name === file.name))
      .then((found) => (found ? { file: found } : { fault: `That plan has no ${file.name}.` }))
      .catch((error: unknown) => ({ fault: wordsOf(error) }))
      .then((answer) => {
        if (wanted) setBeside(answer);
      });
    return () => {
      wanted = false;
    };
  }, [other, planId, asked, file.name]);

  const take = async (chosen: File | undefined): Promise<void> => {
    if (chosen) setOther({ file: { name: chosen.name, text: textOf(await chosen.arrayBuffer()) } });
  };
  return (
    <details class="list-difference">
      <summary>Difference to another list</summary>
      <div class="field-row">
        <select aria-label="Compare with a plan" value={planId ?? ''} onChange={(event) => setOther(event.currentTarget.value ? { plan_id: event.currentTarget.value } : undefined)}>
          <option value="">{other && 'file' in other ? other.file.name : 'Choose a plan'}</option>
          {plans.value.filter(({ plan_id }) => plan_id !== plan.plan_id).map((one) => <option key={one.plan_id} value={one.plan_id}>{titleOf(one)}</option>)}
        </select>
        <button type="button" onClick={() => chooser.current?.click()}><Icon name="file" /> Choose a file</button>
        <input
          ref={chooser} type="file" hidden aria-label="File to compare with"
          onChange={(event) => {
            void take(event.currentTarget.files?.[0]);
            event.currentTarget.value = '';
          }}
        />
      </div>
      {beside?.fault && <p class="fault" role="alert">{beside.fault}</p>}
      {beside?.file && <Lines file={file} other={beside.file} />}
    </details>
  );
}

function Lines({ file, other }: { file: MissionFile; other: MissionFile }): VNode {
  const lines = differenceOf(file.text, other.text);
  const changed = lines.filter(({ side }) => side !== 'both');
  const [gone, come] = (['other', 'this'] as const).map((side) => changed.filter((line) => line.side === side).length);
  return (
    <>
      <p role="status">{changed.length === 0 ? 'The vehicle would read the same in both.' : `${gone} lines only in the other file (−), ${come} only in this one (+); comments left out.`}</p>
      {changed.length > 0 && (
        <pre class="difference-lines" tabIndex={0} aria-label={`Difference of ${file.name} to ${other.name}`}>
          {lines.map(({ side, text }, i) => <span key={i} class={side}>{signs[side]} {text}{'\n'}</span>)}
        </pre>
      )}
    </>
  );
}
