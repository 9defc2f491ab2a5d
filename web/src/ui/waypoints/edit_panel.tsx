import type { VNode } from 'preact';
import { useState } from 'preact/hooks';
import { editedName, saveEdit } from '../../actions/evaluating';
import { formatPosition } from '../../geo/coordinates';
import { reasonTitle } from '../../model/job';
import { asSentence } from '../../model/page_words';
import type { ShownPlan } from '../../model/plan/plans';
import { discardEdit, whyNotSaved, type RouteEdit } from '../../model/plan/route_edit';
import { dialog } from '../../model/screen';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { ask } from '../../model/view';
import { Icon, IconButton } from '../common/icon';
import { Messages } from '../common/messages';
import { PlanKey } from '../common/plan_key';
import { UndoButtons } from '../common/undo_buttons';
import { EditTable } from './edit_table';
import { Figures } from './figures';

/** An edited copy of a plan: its values beside those of the plan, and the button that stores it as a new plan. */
export function EditPanel({ edit, shown }: { edit: RouteEdit; shown: ShownPlan }): VNode {
  const { verdict, figures, origin } = edit;
  const pending = verdict.state === 'pending';
  return (
    <div class="result editing">
      <div class="result-head">
        <h2><PlanKey letter={shown.letter} style={shown.style} /> {editedName(edit)}</h2>
        <UndoButtons />
        <IconButton icon="x" label="Discard the changes" onClick={discardEdit} />
      </div>
      <State edit={edit} />
      {(verdict.state === 'ok' || verdict.state === 'pending') && ( // else they would be those of another route than is drawn
        <>
          <Figures plan={figures} {...(edit.number > 0 ? { beside: origin } : {})} pending={pending} />
          <div class={pending ? 'pending' : undefined}><Messages of={figures} /></div>
        </>
      )}
      <Save edit={edit} />
      <EditTable edit={edit} />
      <p class="hint">
        Drag a handle, or the small one between two to insert. With a waypoint selected and the map in focus: arrows 100 m, with
        Shift 1 km, with Alt 10 m; <kbd>Ins</kbd> <kbd>Del</kbd> <kbd>Tab</kbd>.
      </p>
      {!edit.conditionsKnown && (
        <p class="hint">The server did not say what this plan was asked for: it is judged with its vehicle and data and the set-up’s margin.</p>
      )}
    </div>
  );
}

function State({ edit: { verdict, number } }: { edit: RouteEdit }): VNode {
  switch (verdict.state) {
    case 'pending':
      return <p class="edit-state pending" role="status"><Icon name="refresh" size={14} /> Re-evaluating …</p>;
    case 'ok':
      return <p class="edit-state" role="status">{number === 0 ? 'As planned; nothing changed yet.' : 'Evaluated. Small figures: difference to the plan.'}</p>;
    case 'failed':
      return (
        <section class="failure" aria-label="The route could not be evaluated">
          <h3><Icon name="warning" /> Not evaluated</h3>
          <p>{verdict.detail}</p>
        </section>
      );
    case 'infeasible': {
      const { answer } = verdict;
      return (
        <section class="failure" aria-label="The route cannot be flown">
          <h3><Icon name="warning" /> {reasonTitle(answer.reason)}</h3>
          <p>{asSentence(answer.explanation)}</p>
          <p class="failure-place">
            <button type="button" class="link" onClick={() => ask({ do: 'centre', place: [answer.at.lon, answer.at.lat] })}>
              {formatPosition([answer.at.lon, answer.at.lat], settings.value.coordinates)}
            </button>
            {answer.when && <span> at {shortTime(Date.parse(answer.when))}</span>}
          </p>
        </section>
      );
    }
  }
}

function Save({ edit }: { edit: RouteEdit }): VNode {
  const [saving, setSaving] = useState(false);
  const why = whyNotSaved(edit);
  const save = async (exporting: boolean): Promise<void> => {
    setSaving(true);
    const stored = await saveEdit();
    setSaving(false);
    if (stored && exporting) dialog.value = 'export';
  };
  return (
    <div class="edit-save">
      <button type="button" class="primary" disabled={saving || why !== undefined} onClick={() => void save(false)}>
        <Icon name="save" /> {saving ? 'Storing …' : 'Store as a plan'}
      </button>
      <button type="button" disabled={saving || why !== undefined} onClick={() => void save(true)}>
        <Icon name="download" /> Store and export
      </button>
      {why && edit.number > 0 && <p class="hint">{why}</p>}
    </div>
  );
}
