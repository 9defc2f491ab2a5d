import { signal } from '@preact/signals';
import type { VNode } from 'preact';
import { useEffect } from 'preact/hooks';
import { Icon } from '../common/icon';
import { take } from './file_chooser';

const dragged = signal(false);
const holdsFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;

/** Accepts files dropped anywhere on the page, and shows a hint while they are dragged over it. */
export function DropOverlay(): VNode | null {
  useEffect(() => {
    const over = (event: DragEvent): void => {
      if (!holdsFiles(event)) return;
      event.preventDefault(); // otherwise the browser opens the file instead of the page
      dragged.value = true;
    };
    const leave = (event: DragEvent): void => {
      if (event.relatedTarget === null) dragged.value = false;
    };
    const drop = (event: DragEvent): void => {
      dragged.value = false;
      if (!holdsFiles(event)) return;
      event.preventDefault();
      take(event.dataTransfer?.files ?? null);
    };
    document.addEventListener('dragover', over);
    document.addEventListener('dragleave', leave);
    document.addEventListener('drop', drop);
    return () => {
      document.removeEventListener('dragover', over);
      document.removeEventListener('dragleave', leave);
      document.removeEventListener('drop', drop);
    };
  }, []);
  if (!dragged.value) return null;
  return (
    <div class="drop-overlay" aria-hidden="true">
      <p><Icon name="upload" size={28} /> Drop the files to add them to the store</p>
    </div>
  );
}
