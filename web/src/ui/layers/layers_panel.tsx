import type { VNode } from 'preact';
import { layerNames, layerTitles, toggleLayer, visible } from '../../model/layers';
import { IconButton } from '../common/icon';

/** What the map shows, each with an eye. */
export function LayersPanel(): VNode {
  return (
    <section class="layers" aria-labelledby="layers-title">
      <h2 id="layers-title">Layers</h2>
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
      </ul>
    </section>
  );
}
