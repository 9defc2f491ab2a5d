import type { VNode } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { formatPosition } from '../../geo/coordinates';
import { failure, reasonTitle } from '../../model/job';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { ask } from '../../model/view';
import { Icon, IconButton } from '../common/icon';

/** Why there is no plan: what, where (marked on the map), and what would help. */
export function FailureCard(): VNode | null {
  const fault = failure.value;
  const card = useRef<HTMLElement>(null);
  // On a low screen the card lies below the fold, and a failure must never go unseen.
  useEffect(() => card.current?.scrollIntoView({ block: 'nearest' }), [fault]);
  if (!fault) return null;
  const close = (): void => {
    failure.value = undefined;
  };
  if (fault.kind === 'failed') {
    return (
      <section class="failure" role="alert" aria-label="Planning failed" ref={card}>
        <h3><Icon name="warning" /> {fault.title}</h3>
        <p>{fault.detail}</p>
        <IconButton icon="x" label="Dismiss this message" onClick={close} class="corner" />
      </section>
    );
  }
  const { answer } = fault;
  return (
    <section class="failure" role="alert" aria-label="No plan is possible" ref={card}>
      <h3><Icon name="warning" /> {reasonTitle(answer.reason)}</h3>
      <p>{answer.explanation}</p>
      <p class="failure-place">
        <button type="button" class="link" onClick={() => ask({ do: 'centre', place: [answer.at.lon, answer.at.lat] })}>
          {formatPosition([answer.at.lon, answer.at.lat], settings.value.coordinates)}
        </button>
        {answer.when && <span> at {shortTime(Date.parse(answer.when))}</span>}
      </p>
      {answer.suggestion && (
        <p class="suggestion">
          <b>Try this:</b> {answer.suggestion}
        </p>
      )}
      {answer.warnings.length > 0 && (
        <ul class="warnings">{answer.warnings.map((text) => <li key={text}>{text}</li>)}</ul>
      )}
      <IconButton icon="x" label="Dismiss this message" onClick={close} class="corner" />
    </section>
  );
}
