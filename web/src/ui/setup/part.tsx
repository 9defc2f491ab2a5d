import type { ComponentChildren, VNode } from 'preact';
import { draft, emptyDraft, faults, type Field } from '../../model/setup/draft';
import { namesInGroup } from '../../model/fields';
import { guidePagesOfParts } from '../../model/guide_pages';
import { GuideLink } from '../common/guide_link';

/** Scrolls an opened part to the top of the panel. Below the panel's edge it would seem empty. */
function showWhole({ currentTarget }: Event): void {
  if (!(currentTarget instanceof HTMLDetailsElement) || !currentTarget.open) return;
  const panel = currentTarget.closest('.left-scroll');
  if (panel && currentTarget.getBoundingClientRect().bottom > panel.getBoundingClientRect().bottom - planButton_px) currentTarget.scrollIntoView();
}

/** The height of the button that plans, which covers the lower edge of the panel. */
const planButton_px = 50;

/** A part of the set-up that can be folded, with the fields of its group. Its title shows how many fields were changed. */
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
