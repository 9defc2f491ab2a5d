import type { VNode } from 'preact';
import { hueOf, planDash } from '../../theme/palette';

/** The key of a plan: its letter and a piece of its line, so that colour is not the only sign. */
export function PlanKey({ letter, style }: { letter: string; style: number }): VNode {
  return (
    <span class={`plan-key plan-${hueOf(style)}`}>
      <svg width="22" height="10" aria-hidden="true" focusable="false">
        <line x1="1" y1="5" x2="21" y2="5" stroke="currentColor" stroke-width="3" stroke-dasharray={planDash(style).join(' ')} />
      </svg>
      <b>{letter}</b>
    </span>
  );
}
