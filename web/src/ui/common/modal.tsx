import type { ComponentChildren, VNode } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { guidePages, type GuideTopic } from '../../model/guide_pages';
import { dialog } from '../../model/screen';
import { tool } from '../../model/view';
import { GuideLink } from './guide_link';
import { IconButton } from './icon';

/** A modal dialog: traps the focus, closes with Esc, gives the focus back to where it was, or to the map where a tool waits for a place. */
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
    if (isOpen.current) dialog.value = undefined; // the element tells of its end only after another may have taken its place
  };
  // Left to itself, the element vanishes at once but tells of it later: keys pressed in between would be lost.
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
