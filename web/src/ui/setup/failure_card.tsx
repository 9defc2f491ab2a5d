import type { VNode } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { planWith, planWithChange } from '../../actions/planning';
import type { Change, Infeasible } from '../../contract/types';
import { formatPosition } from '../../geo/coordinates';
import { draft } from '../../model/setup/draft';
import { editFor } from '../../model/setup/draft_answer';
import { failure, isFailureOld, mayHelpWithoutCurrents, reasonTitle, running } from '../../model/job';
import { asSentence, inPageWords } from '../../model/page_words';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { ask } from '../../model/view';
import { Icon, IconButton } from '../common/icon';
import { Messages } from '../common/messages';

/** Buttons for changes that each make a plan possible; a button makes the change and plans again. */
function Changes({ possible }: { possible: Change[] }): VNode {
  return (
    <div class="changes" role="group" aria-label="Changes that help">
      <b>{possible.length === 1 ? 'This change helps:' : 'Any one of these changes helps:'}</b>
      {possible.map((change) => (
        <button type="button" key={change.text} disabled={running.value !== undefined} onClick={() => void planWithChange(change)}>
          <Icon name="route" /> {titleOfChange(change)}
        </button>
      ))}
    </div>
  );
}

function titleOfChange({ text }: Change): string {
  const said = inPageWords(text);
  return said.charAt(0).toUpperCase() + said.slice(1);
}

const hasChanged = 'The set-up has changed since. Plan again to see whether this still holds.';

/** Why there is no plan: the cause and, until the set-up is changed, the place (marked on the map) and what would help. */
export function FailureCard(): VNode | null {
  const fault = failure.value;
  const card = useRef<HTMLElement>(null);
  // The card may lie below the visible part, or be higher than it. The cause must always be seen.
  useEffect(() => card.current?.scrollIntoView({ block: 'start' }), [fault]);
  if (!fault) return null;
  const close = (): void => {
    failure.value = undefined;
  };
  if (fault.kind === 'failed') {
    return (
      <section class="failure" role="alert" aria-label="Planning failed" ref={card}>
        <h3><Icon name="warning" /> {fault.title}</h3>
        <p>{fault.detail}</p>
        {isFailureOld.value ? <p class="hint">{hasChanged}</p> : fault.remedies && fault.remedies.length > 0 && (
          <div class="changes" role="group" aria-label="Changes that may help">
            {fault.remedies.map(({ title, part }) => (
              <button type="button" key={title} disabled={running.value !== undefined} onClick={() => void planWith(part)}>
                <Icon name="route" /> {title}
              </button>
            ))}
          </div>
        )}
        <IconButton icon="x" label="Dismiss this message" onClick={close} class="corner" />
      </section>
    );
  }
  const { answer } = fault;
  return (
    <section class="failure" role="alert" aria-label="No plan is possible" ref={card}>
      <h3><Icon name="warning" /> {reasonTitle(answer.reason)}</h3>
      <p>{asSentence(answer.explanation)}</p>
      {isFailureOld.value ? <p class="hint">{hasChanged}</p> : <Remedies answer={answer} />}
      <Messages of={answer} about=" of the refusal" />
      <IconButton icon="x" label="Dismiss this message" onClick={close} class="corner" />
    </section>
  );
}

/** The place where the search ended, and what would help. */
function Remedies({ answer }: { answer: Infeasible }): VNode {
  const possible = (answer.changes ?? []).filter((change) => editFor(change, draft.value));
  const needsAdvice = possible.length === 0 || answer.changes_cut_short;
  return (
    <>
      <p class="failure-place">
        <button type="button" class="link" onClick={() => ask({ do: 'centre', place: [answer.at.lon, answer.at.lat] })}>
          {formatPosition([answer.at.lon, answer.at.lat], settings.value.coordinates)}
        </button>
        {answer.when && <span> at {shortTime(Date.parse(answer.when))}</span>}
      </p>
      {possible.length > 0 && <Changes possible={possible} />}
      {needsAdvice && answer.suggestion && (
        <p class="suggestion">
          <b>{possible.length > 0 ? 'Or try this:' : 'Try this:'}</b> {asSentence(answer.suggestion)}
        </p>
      )}
      {mayHelpWithoutCurrents(answer) && draft.value.currents !== 'none' && (
        <div class="changes">
          <button type="button" disabled={running.value !== undefined} onClick={() => void planWith({ currents: 'none' })}>
            <Icon name="route" /> Plan without currents
          </button>
          <p class="hint">Such a plan assumes still water: its times and energy hold only where the currents are weak.</p>
        </div>
      )}
    </>
  );
}
