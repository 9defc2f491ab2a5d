import type { VNode } from 'preact';
import { useRef } from 'preact/hooks';
import { draft, edit, emptyDraft, faults, hasGoalsFile, refuse } from '../../model/setup/draft';
import { textOf } from '../../model/file_text';
import { announce } from '../../model/screen';
import { IconButton } from '../common/icon';
import { TextField } from './field';
import { PickButton } from './pick_button';

/** The goal: typed, picked on the map, or from a mission file. */
export function GoalField(): VNode {
  if (hasGoalsFile(draft.value)) return <GoalsFromFile />;
  return (
    <TextField name="to" label="Goal" placeholder="68.9, -53.6">
      <PickButton which="to" label="Pick the goal on the map" />
      <Chooser />
    </TextField>
  );
}

function GoalsFromFile(): VNode {
  const { name } = draft.value.goals_file;
  const fault = faults.value.goals_file;
  return (
    <>
      <div class={fault ? 'field faulty' : 'field'}>
        <label for="field-goals_file">Goals</label>
        <div class="field-row">
          <input
            id="field-goals_file" type="text" readOnly value={name} title={name} aria-invalid={fault ? true : undefined}
            aria-describedby={fault ? 'fault-goals_file' : 'hint-goals_file'}
          />
          <Chooser />
          <IconButton icon="x" label={`Remove ${name}`} onClick={() => edit({ goals_file: emptyDraft.goals_file, route_name: emptyDraft.route_name })} />
        </div>
        {fault
          ? <p class="fault" id="fault-goals_file">{fault}</p>
          : <p class="hint" id="hint-goals_file">The file’s places in the order flown. With no start above, the first of them is the start.</p>}
      </div>
      <TextField name="route_name" />
    </>
  );
}

/** The largest file that the server accepts. */
const most_bytes = 1 << 20;

async function take(file: File | undefined): Promise<void> {
  if (!file) return;
  if (file.size > most_bytes) {
    refuse({ to: `${file.name} is larger than 1 MiB: is it a mission file?` });
    return;
  }
  edit({ goals_file: { name: file.name, text: textOf(await file.arrayBuffer()) }, route_name: emptyDraft.route_name });
  announce(`The goals come from ${file.name}.`);
}

function Chooser(): VNode {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <IconButton icon="file" label="Take the goals from a mission file" onClick={() => input.current?.click()} />
      <input
        ref={input} type="file" hidden aria-label="File with the goals"
        onChange={(event) => {
          void take(event.currentTarget.files?.[0]);
          event.currentTarget.value = '';
        }}
      />
    </>
  );
}
