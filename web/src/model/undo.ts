import { computed, signal } from '@preact/signals';

/** Something that a person has done to the work on the desk, with the way back and forth. */
export interface Change {
  title: string; // after "Undo": "moving waypoint 3"
  back: () => void | Promise<void>;
  again: () => void | Promise<void>;
  typing?: string; // the field that is being typed in: letters that follow on from each other are one change
  of?: string; // what it belongs to, and is forgotten with
}

/** All changes since the page was opened, of the set-up, of routes, of plans and of what is made by hand, in one line. */
interface Changes {
  past: readonly Change[];
  future: readonly Change[];
}

const remembered = 200;
const changes = signal<Changes>({ past: [], future: [] });

/** What undo would take back, and redo make again. */
export const lastDone = computed(() => changes.value.past.at(-1));
export const lastUndone = computed(() => changes.value.future[0]);

/** Typing goes on in the change before until something is undone or done again. */
let typingIsOpen = false;

/** Takes in what has just been done. What had been undone is forgotten. */
export function remember(change: Change): void {
  const { past } = changes.peek();
  const before = past.at(-1);
  const goesOn = typingIsOpen && change.typing !== undefined && before?.typing === change.typing;
  const next = goesOn ? [...past.slice(0, -1), { ...change, back: before.back }] : [...past, change];
  changes.value = { past: next.slice(-remembered), future: [] };
  typingIsOpen = true;
}

/** The end of those that the server takes part in: each begins when the one before it is over. */
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

/** Takes the last change back; which one, if any. */
export function undo(): Change | undefined {
  const { past, future } = changes.peek();
  const change = past.at(-1);
  if (!change) return undefined;
  changes.value = { past: past.slice(0, -1), future: [change, ...future] };
  turn(change.back);
  return change;
}

/** Makes again what was last taken back; which change, if any. */
export function redo(): Change | undefined {
  const { past, future } = changes.peek();
  const change = future[0];
  if (!change) return undefined;
  changes.value = { past: [...past, change], future: future.slice(1) };
  turn(change.again);
  return change;
}

/** What has gone for good takes its changes with it. */
export function forgetChanges(of: string): void {
  const { past, future } = changes.peek();
  const isKept = (change: Change): boolean => change.of !== of;
  changes.value = { past: past.filter(isKept), future: future.filter(isKept) };
}
