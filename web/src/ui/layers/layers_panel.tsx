import type { VNode } from 'preact';
import { useState } from 'preact/hooks';
import { guidePages } from '../../model/guide_pages';
import { layerNames, layerTitles, toggleLayer, visible } from '../../model/layers';
import { GuideLink } from '../common/guide_link';
import { IconButton } from '../common/icon';

/** If the window is smaller, the list is folded at first, so that the set-up and its messages have room. */
const roomy = '(min-height: 800px) and (min-width: 901px)';

/** The layers of the map, each with a button that shows or hides it. */
export function LayersPanel(): VNode {
  const [open] = useState(() => matchMedia(roomy).matches);
  return (
    <details class="layers" open={open}>
      <summary>Layers</summary>
      <ul>
        {layerNames.map((name) => {
          const on = visible.value[name];
          return (
            <li key={name} class={on ? '' : 'off'}>
              <IconButton icon={on ? 'eye' : 'eyeOff'} label={`Show ${layerTitles[name].toLowerCase()}`} pressed={on} onClick={() => toggleLayer(name)} />
              <span>{layerTitles[name]}</span>
            </li>
          );
        })}
        <li><GuideLink page={guidePages.layers} /></li>
      </ul>
    </details>
  );
}
