import { effect } from '@preact/signals';
import { draft, emptyDraft, fill, type Draft } from './draft';

const key = 'floeplan.draft';

/** Restores the unfinished set-up of the last visit, and stores what is typed from now on. Call once. */
export function keepDraft(): void {
  try {
    const read: unknown = JSON.parse(localStorage.getItem(key) ?? 'null');
    if (read !== null && typeof read === 'object') fill(known(read));
  } catch {
    // A text that cannot be read was not written by this page, or is damaged.
  }
  effect(() => {
    const text = JSON.stringify(draft.value);
    try {
      localStorage.setItem(key, text);
    } catch {
      // A browser that refuses storage only forgets the set-up.
    }
  });
}

/** The members that a set-up has in this version, if their types are right. */
function known(read: Partial<Record<keyof Draft, unknown>>): Partial<Draft> {
  const fields = (Object.keys(emptyDraft) as (keyof Draft)[]).filter((name) => {
    const value = read[name];
    return typeof value === typeof emptyDraft[name] && Array.isArray(value) === Array.isArray(emptyDraft[name]);
  });
  return Object.fromEntries(fields.map((name) => [name, read[name]]));
}
