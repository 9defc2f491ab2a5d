import type { ComponentChildren, VNode } from 'preact';
import { draft, emptyDraft, faults, type Field } from '../../model/draft';
import { namesInGroup } from '../../model/fields';
import { guidePagesOfParts } from '../../model/guide_pages';
import { GuideLink } from '../common/guide_link';

/** What was opened is read from its top: the panel is low, and a part below its edge would seem empty. */
function showWhole({ currentTarget }: Event): void {
  if (!(currentTarget instanceof HTMLDetailsElement) || !currentTarget.open) return;
  const panel = currentTarget.closest('.left-scroll');
  if (panel && currentTarget.getBoundingClientRect().bottom > panel.getBoundingClientRect().bottom - planButton_px) currentTarget.scrollIntoView();
}

/** The button that plans stands over the panel's lower edge. */
const planButton_px = 50;

/** A part of the set-up that can be folded, with the fields of the group of its title; says how much in it was changed. */
export function Part({ title, children }: { title: string; children: ComponentChildren }): VNode {
  const fields = namesInGroup(title) as Field[];
  const faulty = fields.some((field) => faults.value[field]);
  const page = guidePagesOfParts[title];
  const changed = fields.filter((field) => JSON.stringify(draft.value[field]).replaceAll(' ', '') !== JSON.stringify(emptyDraft[field])).length;
  return (
    <details class="advanced" open={faulty || undefined} onToggle={showWhole}>
      <summary>
        {title}
        {changed > 0 && <span class="count" title={`${changed} changed`}>{changed}</span>}
      </summary>
      {children}
      {page && <GuideLink page={page} />}
    </details>
  );
}
