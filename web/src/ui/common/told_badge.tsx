import type { VNode } from 'preact';
import type { Plan } from '../../contract/types';
import { countOf, ofRank, type Rank } from '../../model/messages';
import { Icon } from './icon';

/** The number of a plan's messages of a rank; the tooltip shows the messages. */
export function ToldBadge({ plan, rank }: { plan: Plan; rank: Rank }): VNode | null {
  const told = ofRank(plan, rank);
  if (told.length === 0) return null;
  return (
    <span class={rank === 'danger' ? 'badge bad' : 'badge'} title={told.map(({ text }) => text).join('\n')}>
      <Icon name="warning" size={12} /> {countOf(told.length, rank)}
    </span>
  );
}
