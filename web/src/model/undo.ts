import { computed, signal } from '@preact/signals';

/** A change that a person made, with the functions that undo it and make it again. */
export interface Change {
  title: string; // after "Undo": "moving waypoint 3"
  back: () => void | Promise<void>;
  again: () => void | Promise<void>;
  typing?: string; // the field that is being typed in: consecutive letters are one change
  of?: string; // what it belongs to; the change is forgotten together with that
}

/** All changes since the page was opened, in one list: of the set-up, routes, plans and manual entries. */
interface Changes {
  past: readonly Change[];
  future: readonly Change[];
}

const remembered = 200;
const changes = signal<Changes>({ past: [], future: [] });

/** The titles of the changes that undo and redo would act on. */
export const lastDone = computed(() => changes.value.past.at(-1));
export const lastUndone = computed(() => changes.value.future[0]);

/** Whether further typing belongs to the last change. Undo and redo end this. */
let typingIsOpen = false;

/** Adds a change that was just made. Changes that had been undone are forgotten. */
export function remember(change: Change): void {
  const { past } = changes.peek();
  const before = past.at(-1);
  const goesOn = typingIsOpen && change.typing !== undefined && before?.typing === change.typing;
  const next = goesOn ? [...past.slice(0, -1), { ...change, back: before.back }] : [...past, change];
  changes.value = { past: next.slice(-remembered), future: [] };
  typingIsOpen = true;
}

/** Settles when the changes that need the server have ended. They run one after the other. */
let pending: Promise<void> | undefined;

function turn(way: () => void | Promise<void>): void {
  typingIsOpen = false;
  const begun = pending ? pending.then(way, way) : way();
  if (!begun) return;
  const over = begun.finally(() => {
    if (pending === over) pending = undefined;
  });
  pending = over;
}

/** Undoes the last change. Returns it, or undefined where there is none. */
export function undo(): Change | undefined {
  const { past, future } = changes.peek();
  const change = past.at(-1);
  if (!change) return undefined;
  changes.value = { past: past.slice(0, -1), future: [change, ...future] };
  turn(change.back);
  return change;
}

/** Makes the change again that was undone last. Returns it, or undefined where there is none. */
export function redo(): Change | undefined {
  const { past, future } = changes.peek();
  const change = future[0];
  if (!change) return undefined;
  changes.value = { past: [...past, change], future: future.slice(1) };
  turn(change.again);
  return change;
}

/** Forgets the changes of something that no longer exists. */
export function forgetChanges(of: string): void {
  const { past, future } = changes.peek();
  const isKept = (change: Change): boolean => change.of !== of;
  changes.value = { past: past.filter(isKept), future: future.filter(isKept) };
}
