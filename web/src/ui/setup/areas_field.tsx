import type { VNode } from 'preact';
import { useState } from 'preact/hooks';
import { cornersIn, cornersText, newArea, type Area } from '../../model/area';
import { draft, edit, faults } from '../../model/draft';
import { drawer } from '../../model/screen';
import { tool, view } from '../../model/view';
import { Icon, IconButton } from '../common/icon';

/** Areas to keep out of or to stay in: drawn on the map or typed corner by corner. */
export function AreasField(): VNode {
  const { areas } = draft.value;
  const fault = faults.value.areas;
  const set = (next: Area[]): void => edit({ areas: next });
  const drawing = tool.value === 'area';
  return (
    <fieldset class={fault ? 'field places faulty' : 'field places'}>
      <legend>Areas</legend>
      {areas.map((area, i) => (
        <AreaRow
          key={i} area={area} number={i + 1} onChange={(part) => set(areas.map((old, j) => (j === i ? { ...old, ...part } : old)))}
          onRemove={() => set(areas.filter((_, j) => j !== i))}
        />
      ))}
      {fault && <p class="fault" id="fault-areas">{fault}</p>}
      <div class="field-row">
        <button
          type="button" aria-pressed={drawing} class={drawing ? 'primary' : ''}
          onClick={() => {
            tool.value = drawing ? 'pan' : 'area';
            drawer.value = undefined;
          }}
        >
          <Icon name="polygon" /> Draw an area
        </button>
        <button type="button" onClick={() => set([...areas, newArea(squareInView(), areas.length + 1)])}><Icon name="plus" /> Type one</button>
      </div>
    </fieldset>
  );
}

/** A quarter of what is in view, for a start. */
function squareInView(): Area['corners'] {
  const [west, south, east, north] = view.value?.box ?? [-52, 69, -51, 69.2];
  const [x, y] = view.value?.centre ?? [(west + east) / 2, (south + north) / 2];
  const [dx, dy] = [(east - west) / 12, (north - south) / 12];
  return [[x - dx, y - dy], [x + dx, y - dy], [x + dx, y + dy], [x - dx, y + dy]];
}

interface AreaRowProps {
  area: Area;
  number: number;
  onChange: (part: Partial<Area>) => void;
  onRemove: () => void;
}

function AreaRow({ area, number, onChange, onRemove }: AreaRowProps): VNode {
  return (
    <div class="area-row">
      <div class="field-row">
        <input type="text" aria-label={`Name of area ${number}`} value={area.name} onInput={(event) => onChange({ name: event.currentTarget.value })} />
        <select
          aria-label={`What area ${number} asks`} value={area.kind}
          onChange={(event) => onChange({ kind: event.currentTarget.value === 'stay_in' ? 'stay_in' : 'no_go' })}
        >
          <option value="no_go">keep out</option>
          <option value="stay_in">stay in</option>
        </select>
        <IconButton icon="trash" label={`Remove area ${number}`} onClick={onRemove} />
      </div>
      <details>
        <summary>{area.corners.length} corners{area.from || area.until ? ', at times' : ''}{area.top_m || area.bottom_m ? ', at depths' : ''}</summary>
        <Corners area={area} number={number} onChange={onChange} />
        <div class="field-pair">
          <div class="field">
            <label for={`area-from-${number}`}>From <span class="unit">UTC</span></label>
            <input id={`area-from-${number}`} type="text" placeholder="always" value={area.from} onInput={(event) => onChange({ from: event.currentTarget.value })} />
          </div>
          <div class="field">
            <label for={`area-until-${number}`}>Until <span class="unit">UTC</span></label>
            <input id={`area-until-${number}`} type="text" placeholder="always" value={area.until} onInput={(event) => onChange({ until: event.currentTarget.value })} />
          </div>
        </div>
        <div class="field-pair">
          <div class="field">
            <label for={`area-top-${number}`}>Below <span class="unit">m</span></label>
            <input id={`area-top-${number}`} type="text" inputMode="decimal" placeholder="surface" value={area.top_m ?? ''} onInput={(event) => onChange({ top_m: event.currentTarget.value })} />
          </div>
          <div class="field">
            <label for={`area-bottom-${number}`}>Above <span class="unit">m</span></label>
            <input id={`area-bottom-${number}`} type="text" inputMode="decimal" placeholder="sea bed" value={area.bottom_m ?? ''} onInput={(event) => onChange({ bottom_m: event.currentTarget.value })} />
          </div>
        </div>
      </details>
    </div>
  );
}

/** Corners as text; what cannot be read stays in the field, with its fault, and changes nothing. */
function Corners({ area, number, onChange }: Omit<AreaRowProps, 'onRemove'>): VNode {
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const read = typed === undefined ? undefined : cornersIn(typed);
  const fault = read && 'fault' in read ? read.fault : undefined;
  return (
    <div class={fault ? 'field faulty' : 'field'}>
      <label for={`area-corners-${number}`}>Corners, one on each line</label>
      <textarea
        id={`area-corners-${number}`} rows={4} spellcheck={false} value={typed ?? cornersText(area.corners)} aria-invalid={fault ? true : undefined}
        onInput={(event) => {
          setTyped(event.currentTarget.value);
          const now = cornersIn(event.currentTarget.value);
          if ('corners' in now) onChange({ corners: now.corners });
        }}
        onBlur={() => { if (!fault) setTyped(undefined); }}
      />
      {fault && <p class="fault" role="alert">{fault}</p>}
    </div>
  );
}
