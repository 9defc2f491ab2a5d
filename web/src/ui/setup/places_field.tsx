import type { VNode } from 'preact';
import { checkPlaces, draft, edit, faults } from '../../model/setup/draft';
import { Icon, IconButton } from '../common/icon';
import { PickButton } from './pick_button';

/** The via points, each on a line of its own: typed, picked on the map, moved up and down. */
export function PlacesField(): VNode {
  const lines = draft.value.via === '' ? [] : draft.value.via.split('\n');
  const fault = faults.value.via;
  const set = (next: string[], typing?: string): void => edit({ via: next.join('\n') }, typing);
  const swap = (i: number, j: number): void => {
    const next = [...lines];
    [next[i], next[j]] = [lines[j] ?? '', lines[i] ?? ''];
    set(next);
  };
  return (
    <fieldset class={fault ? 'field places faulty' : 'field places'}>
      <legend>Via points</legend>
      {lines.map((line, i) => (
        <div class="field-row" key={i}>
          <input
            type="text" id={i === 0 ? 'field-via' : undefined} aria-label={`Via point ${i + 1}`} value={line} placeholder="69°05.0′N 52°00.0′W"
            autocomplete="off" spellcheck={false} aria-invalid={fault ? true : undefined} aria-describedby={fault ? 'fault-via' : undefined}
            onInput={(event) => set(lines.map((old, j) => (j === i ? event.currentTarget.value : old)), `via ${i}`)}
            onChange={() => checkPlaces('via')}
          />
          <IconButton icon="up" label={`Move via point ${i + 1} up`} disabled={i === 0} onClick={() => swap(i, i - 1)} />
          <IconButton icon="x" label={`Remove via point ${i + 1}`} onClick={() => set(lines.filter((_, j) => j !== i))} />
        </div>
      ))}
      {fault && <p class="fault" id="fault-via">{fault}</p>}
      <div class="field-row">
        <button type="button" onClick={() => set([...lines, ' '])}><Icon name="plus" /> Add a via point</button>
        <PickButton which="via" label="Pick via points on the map" />
      </div>
      {lines.length > 1 && (
        <select
          aria-label="Order of the via points" value={draft.value.via_order}
          onChange={(event) => edit({ via_order: event.currentTarget.value === 'best' ? 'best' : 'given' })}
        >
          <option value="given">Visit them in this order</option>
          <option value="best">Visit them in the best order</option>
        </select>
      )}
    </fieldset>
  );
}
