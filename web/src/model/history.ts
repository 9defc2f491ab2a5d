/** Something that is changed step by step, with the way back and forth. Values are never changed in place. */
export interface History<T> {
  past: readonly T[];
  now: T;
  future: readonly T[];
}

const remembered = 200;

export const begin = <T>(now: T): History<T> => ({ past: [], now, future: [] });

/** A new step; what had been undone is forgotten. */
export const record = <T>({ past, now }: History<T>, next: T): History<T> => ({
  past: [...past, now].slice(-remembered), now: next, future: [],
});

export function undo<T>(history: History<T>): History<T> {
  if (history.past.length === 0) return history;
  const before = history.past.at(-1) as T;
  return { past: history.past.slice(0, -1), now: before, future: [history.now, ...history.future] };
}

export function redo<T>(history: History<T>): History<T> {
  if (history.future.length === 0) return history;
  const after = history.future[0] as T;
  return { past: [...history.past, history.now], now: after, future: history.future.slice(1) };
}
