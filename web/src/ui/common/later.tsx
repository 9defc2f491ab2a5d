import type { ComponentType, VNode } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { dialog, tell } from '../../model/screen';

/** A dialog whose code is fetched when it is first opened; where it cannot be had, that is said and the dialog stays closed. */
export function dialogLater(fetchIt: () => Promise<ComponentType>): () => VNode | null {
  let fetched: ComponentType | undefined;
  return function Later() {
    const [Dialog, setDialog] = useState<ComponentType | undefined>(() => fetched);
    useEffect(() => {
      let wanted = true;
      fetchIt()
        .then((component) => {
          fetched = component;
          if (wanted) setDialog(() => component);
        })
        .catch(() => {
          if (!wanted) return;
          dialog.value = undefined;
          tell('The server did not hand out this dialog. Reload the page and try again.');
        });
      return () => {
        wanted = false;
      };
    }, []);
    return Dialog ? <Dialog /> : null;
  };
}
