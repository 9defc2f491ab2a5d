import type { ComponentChildren, VNode } from 'preact';
import { draft, emptyDraft, faults, type Field } from '../../model/draft';

/** A part of the set-up that can be folded; says how much in it was changed. */
export function Part({ title, fields, children }: { title: string; fields: Field[]; children: ComponentChildren }): VNode {
  const faulty = fields.some((field) => faults.value[field]);
  const changed = fields.filter((field) => JSON.stringify(draft.value[field]).replaceAll(' ', '') !== JSON.stringify(emptyDraft[field])).length;
  return (
    <details class="advanced" open={faulty || undefined}>
      <summary>
        {title}
        {changed > 0 && <span class="count" title={`${changed} changed`}>{changed}</span>}
      </summary>
      {children}
    </details>
  );
}
