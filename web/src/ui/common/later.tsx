import type { ComponentType, VNode } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { dialog, tell } from '../../model/screen';

/** A part of the page whose code is loaded when it is first shown. A failure to load it is shown in its place. */
export function later<Props extends object>(fetchIt: () => Promise<ComponentType<Props>>, giveUp: () => void = () => undefined): (props: Props) => VNode | null {
  let fetched: ComponentType<Props> | undefined;
  return function Later(props: Props) {
    const [Part, setPart] = useState<ComponentType<Props> | undefined>(() => fetched);
    useEffect(() => {
      let wanted = true;
      fetchIt()
        .then((component) => {
          fetched = component;
          if (wanted) setPart(() => component);
        })
        .catch(() => {
          if (!wanted) return;
          giveUp();
          tell('The server did not hand out this part of the page. Reload the page and try again.');
        });
      return () => {
        wanted = false;
      };
    }, []);
    return Part ? <Part {...props} /> : null;
  };
}

/** A dialog whose code is loaded when it is first shown. It stays closed if the code cannot be loaded. */
export const dialogLater = (fetchIt: () => Promise<ComponentType>): (() => VNode | null) => {
  const Dialog = later<object>(fetchIt, () => {
    dialog.value = undefined;
  });
  return () => <Dialog />;
};
