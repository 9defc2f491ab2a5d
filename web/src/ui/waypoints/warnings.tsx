import type { VNode } from 'preact';
import { cautionsOf, dangersOf } from '../../model/dangers';
import { inPageWords } from '../../model/page_words';
import { Icon } from '../common/icon';

/** What may cost the vehicle, before all else that the pilot has to know. */
export function Warnings({ of }: { of: { dangers?: string[]; warnings: string[] } }): VNode {
  return (
    <>
      <Box texts={dangersOf(of)} word="danger" kind="danger-box" />
      <Box texts={cautionsOf(of)} word="warning" kind="warning-box" />
    </>
  );
}

function Box({ texts, word, kind }: { texts: string[]; word: 'danger' | 'warning'; kind: string }): VNode | null {
  if (texts.length === 0) return null;
  return (
    <section class={kind} aria-label={word === 'danger' ? 'Dangers' : 'Warnings'}>
      <h3><Icon name="warning" /> {texts.length === 1 ? `1 ${word}` : `${texts.length} ${word}s`}</h3>
      <ul>{texts.map((text) => <li key={text}>{inPageWords(text)}</li>)}</ul>
    </section>
  );
}
