import type { VNode } from 'preact';
import { whyNoAlternatives } from '../../model/plan/alternatives';
import { draft } from '../../model/setup/draft';
import { guidePages } from '../../model/guide_pages';
import { GuideLink } from '../common/guide_link';
import { SelectField, type Choice } from './field';

const choices: Choice[] = [
  { value: '', title: 'None' },
  ...['1', '2', '3'].map((count) => ({ value: count, title: count })),
];

const hintId = 'hint-alternatives';

/** The number of routes around the other side of large obstacles. */
export const AlternativesField = (): VNode => <SelectField name="alternatives" choices={choices} closed={whyNoAlternatives(draft.value) && hintId} />;

/**
 * The meaning of that number, or why alternatives cannot be chosen. It is below the row of the field, over the whole
 * width.
 */
export function AlternativesHint(): VNode | null {
  const why = whyNoAlternatives(draft.value);
  if (why) return <p class="hint" id={hintId}>{why}</p>;
  if (draft.value.alternatives === '') return null;
  return (
    <p class="hint" id={hintId}>
      Also looks for routes on the other side of large obstacles, up to twice as long in time. Each becomes a plan of its own. <GuideLink page={guidePages.alternatives} />
    </p>
  );
}
