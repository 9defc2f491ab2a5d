import type { VNode } from 'preact';
import { inPageWords } from '../../model/page_words';
import { Icon } from '../common/icon';

export function Warnings({ warnings }: { warnings: string[] }): VNode | null {
  if (warnings.length === 0) return null;
  return (
    <section class="warning-box" aria-label="Warnings">
      <h3><Icon name="warning" /> {warnings.length === 1 ? '1 warning' : `${warnings.length} warnings`}</h3>
      <ul>{warnings.map((text) => <li key={text}>{inPageWords(text)}</li>)}</ul>
    </section>
  );
}
