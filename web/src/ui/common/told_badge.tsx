import type { VNode } from 'preact';
import type { Plan } from '../../contract/types';
import { countOf, ofRank, type Rank } from '../../model/messages';
import { Icon } from './icon';

/** How many messages of a rank a plan has; the messages where it is pointed at. */
export function ToldBadge({ plan, rank }: { plan: Plan; rank: Rank }): VNode | null {
  const told = ofRank(plan, rank);
  if (told.length === 0) return null;
  return (
    <span class={rank === 'danger' ? 'badge bad' : 'badge'} title={told.map(({ text }) => text).join('\n')}>
      <Icon name="warning" size={12} /> {countOf(told.length, rank)}
    </span>
  );
}
