import type { VNode } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { drawer } from '../../model/screen';
import { tool, type Tool } from '../../model/view';
import { IconButton } from '../common/icon';
import { goOnByKey } from '../placing_keys';

/**
 * Picks a place on the map; a second press cancels that. Where the map has moved on to this place by itself, as from the start to
 * the goal, the first press of this button does not cancel.
 */
export function PickButton({ which, label }: { which: Tool; label: string }): VNode {
  const [isPressed, setPressed] = useState(false);
  const isActive = tool.value === which;
  useEffect(() => {
    if (!isActive) setPressed(false);
  }, [isActive]);
  return (
    <IconButton
      icon="crosshair" label={label} pressed={isActive}
      onClick={(event) => {
        const givesUp = isActive && isPressed;
        tool.value = givesUp ? 'pan' : which;
        setPressed(!givesUp);
        drawer.value = undefined;
        goOnByKey(event);
      }}
    />
  );
}
