import type { VNode } from 'preact';
import { tell } from '../../model/screen';
import { lastDone, lastUndone, redo, undo } from '../../model/undo';
import { IconButton } from './icon';

/** A button that undoes the last change and names it. */
export function undoAndTell(): void {
  const change = undo();
  if (change) tell(`Undone: ${change.title}.`);
}

export function redoAndTell(): void {
  const change = redo();
  if (change) tell(`Done again: ${change.title}.`);
}

/** Undo and redo for all changes, the same in every place. */
export function UndoButtons(): VNode {
  const [back, again] = [lastDone.value, lastUndone.value];
  return (
    <>
      <IconButton icon="undo" label="Undo (Ctrl+Z)" hint={back?.title} disabled={!back} onClick={undoAndTell} />
      <IconButton icon="redo" label="Redo (Ctrl+Shift+Z)" hint={again?.title} disabled={!again} onClick={redoAndTell} />
    </>
  );
}
