import type { VNode } from 'preact';
import { drawer } from '../../model/screen';
import { tool, type Tool } from '../../model/view';
import { IconButton } from '../common/icon';

/** Picks a place on the map; pressed again it gives up. */
export function PickButton({ which, label }: { which: Tool; label: string }): VNode {
  const active = tool.value === which;
  return (
    <IconButton
      icon="crosshair" label={label} pressed={active}
      onClick={() => {
        tool.value = active ? 'pan' : which;
        drawer.value = undefined;
      }}
    />
  );
}
