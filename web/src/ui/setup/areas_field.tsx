import type { VNode } from 'preact';
import { useState } from 'preact/hooks';
import { cornersIn, cornersText, newArea, type Area } from '../../model/area';
import { draft, edit, faults } from '../../model/setup/draft';
import { drawer } from '../../model/screen';
import { tool, view } from '../../model/view';
import { Icon, IconButton } from '../common/icon';
import { goOnByKey } from '../placing_keys';

/** Areas to keep out of or to stay in: drawn on the map or typed corner by corner. */
export function AreasField(): VNode {
  const { areas } = draft.value;
  const fault = faults.value.areas;
  const set = (next: Area[], typing?: string): void => edit({ areas: next }, typing);
  const drawing = tool.value === 'area';
  return (
    <fieldset class={fault ? 'field places faulty' : 'field places'}>
      <legend>Areas</legend>
      {areas.map((area, i) => (
        <AreaFields
          key={i} area={area} id={`area-${i + 1}`} called={`area ${i + 1}`} onChange={(part) => set(areas.map((old, j) => (j === i ? { ...old, ...part } : old)), `area ${i} ${Object.keys(part).join()}`)}
          onRemove={() => set(areas.filter((_, j) => j !== i))}
        />
      ))}
      {fault && <p class="fault" id="fault-areas">{fault}</p>}
      <div class="field-row">
        <button
          type="button" aria-pressed={drawing} class={drawing ? 'primary' : ''}
          onClick={(event) => {
            tool.value = drawing ? 'pan' : 'area';
            drawer.value = undefined;
            goOnByKey(event);
          }}
        >
          <Icon name="polygon" /> Draw an area
        </button>
        <button type="button" onClick={() => set([...areas, newArea(squareInView(), areas.length + 1)])}><Icon name="plus" /> Type one</button>
      </div>
    </fieldset>
  );
}

/** A first outline: a quarter of the area in view. */
function squareInView(): Area['corners'] {
  const [west, south, east, north] = view.value?.box ?? [-52, 69, -51, 69.2];
  const [x, y] = view.value?.centre ?? [(west + east) / 2, (south + north) / 2];
  const [dx, dy] = [(east - west) / 12, (north - south) / 12];
  return [[x - dx, y - dy], [x + dx, y - dy], [x + dx, y + dy], [x - dx, y + dy]];
}

interface AreaFieldsProps {
  area: Area;
  id: string; // prefix of the ids of its fields in the page
  called: string;
  onChange: (part: Partial<Area>) => void;
  onRemove?: () => void;
}

/** The form of an area: its name and rule, and, folded, its corners, times and depths. */
export function AreaFields({ area, id, called, onChange, onRemove }: AreaFieldsProps): VNode {
  const extent = (name: 'from' | 'until' | 'top_m' | 'bottom_m', label: string, unit: string, placeholder: string): VNode => (
    <div class="field">
      <label for={`${id}-${name}`}>{label} <span class="unit">{unit}</span></label>
      <input
        id={`${id}-${name}`} type="text" inputMode={unit === 'm' ? 'decimal' : 'text'} placeholder={placeholder} value={area[name] ?? ''}
        onInput={(event) => onChange({ [name]: event.currentTarget.value })}
      />
    </div>
  );
  return (
    <div class="area-row">
      <div class="field-row">
        <input type="text" aria-label={`Name of ${called}`} value={area.name} onInput={(event) => onChange({ name: event.currentTarget.value })} />
        <select
          aria-label={`What ${called} asks`} value={area.kind}
          onChange={(event) => onChange({ kind: event.currentTarget.value === 'stay_in' ? 'stay_in' : 'no_go' })}
        >
          <option value="no_go">keep out</option>
          <option value="stay_in">stay in</option>
        </select>
        {onRemove && <IconButton icon="trash" label={`Remove ${called}`} onClick={onRemove} />}
      </div>
      <details>
        <summary>{area.corners.length} corners{area.from || area.until ? ', at times' : ''}{area.top_m || area.bottom_m ? ', at depths' : ''}</summary>
        <Corners area={area} id={id} onChange={onChange} />
        <div class="field-pair">{extent('from', 'From', 'UTC', 'always')}{extent('until', 'Until', 'UTC', 'always')}</div>
        <div class="field-pair">{extent('top_m', 'Below', 'm', 'surface')}{extent('bottom_m', 'Above', 'm', 'sea bed')}</div>
      </details>
    </div>
  );
}

/** The corners as text. A text that cannot be read stays in the field with its fault, and the area does not change. */
function Corners({ area, id, onChange }: Pick<AreaFieldsProps, 'area' | 'id' | 'onChange'>): VNode {
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const read = typed === undefined ? undefined : cornersIn(typed);
  const fault = read && 'fault' in read ? read.fault : undefined;
  return (
    <div class={fault ? 'field faulty' : 'field'}>
      <label for={`${id}-corners`}>Corners, one on each line</label>
      <textarea
        id={`${id}-corners`} rows={4} spellcheck={false} value={typed ?? cornersText(area.corners)} aria-invalid={fault ? true : undefined}
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
