import type { ComponentChildren, VNode } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { guidePages, type GuideTopic } from '../../model/guide_pages';
import { dialog } from '../../model/screen';
import { tool } from '../../model/view';
import { GuideLink } from './guide_link';
import { IconButton } from './icon';

/**
 * A modal dialog: traps the focus, closes with Esc, returns the focus to the element before, or to the map if a tool
 * waits for a place.
 */
export function Modal({ title, guide, wide, children }: { title: string; guide: GuideTopic; wide?: boolean; children: ComponentChildren }): VNode {
  const box = useRef<HTMLDialogElement>(null);
  const isOpen = useRef(true);
  useEffect(() => {
    const element = box.current;
    const before = document.activeElement;
    element?.showModal();
    return () => {
      isOpen.current = false;
      element?.close();
      if (tool.peek() !== 'pan') document.getElementById('map')?.focus();
      else if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  const close = (): void => {
    if (isOpen.current) dialog.value = undefined; // the close event may come after another dialog was opened in its place
  };
  // By default the element disappears at once but reports it later: keys pressed in between would be lost.
  const closeAtOnce = (event: Event): void => {
    event.preventDefault();
    close();
  };
  return (
    <dialog
      ref={box} class={wide ? 'modal wide' : 'modal'} aria-labelledby="modal-title"
      onCancel={closeAtOnce} onClose={close}
    >
      <div class="modal-head">
        <h2 id="modal-title">{title}</h2>
        <GuideLink page={guidePages[guide]} />
        <IconButton icon="x" label="Close" onClick={close} />
      </div>
      <div class="modal-body">{children}</div>
    </dialog>
  );
}
