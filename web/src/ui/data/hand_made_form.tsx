import type { VNode } from 'preact';
import { closeForm, openExisting, saveForm, saveOverTheirs } from '../../actions/hand_made';
import type { Area } from '../../model/area';
import { changeBerg, changeForm, nameOf, type BergForm, type OpenForm } from '../../model/hand_made';
import { sizeTitle } from '../../model/ice/icebergs';
import { drawer } from '../../model/screen';
import { tool } from '../../model/view';
import { Icon, IconButton } from '../common/icon';
import { AreaFields } from '../setup/areas_field';

const sizes = ['growler', 'bergy_bit', 'small', 'medium', 'large', 'very_large', 'unknown', 'radar_target'];

/** The form of a new or changed iceberg or zone, typed or picked on the map. */
export function HandMadeForm({ form }: { form: OpenForm }): VNode {
  const { before, berg, faults, state, zone } = form;
  const what = berg ? 'iceberg' : 'zone';
  const submit = (event: Event): void => {
    event.preventDefault();
    void saveForm();
  };
  return (
    <form class="hand-form" onSubmit={submit} noValidate aria-label={before ? `Change ${nameOf(before)}` : `New ${what}`} aria-busy={state === 'saving'}>
      <h3>{before ? nameOf(before) : `New ${what}`}</h3>
      {berg && <BergFields berg={berg} faults={faults} />}
      {zone && <ZoneFields zone={zone} />}
      {faults.zone && <p class="fault" role="alert">{faults.zone}</p>}
      <Trouble form={form} />
      <div class="field-row">
        <button type="submit" class="primary" disabled={state === 'saving' || state === 'conflict'}>
          <Icon name="save" /> {state === 'saving' ? 'Storing …' : state === 'removed' ? 'Store again' : 'Store'}
        </button>
        <button type="button" onClick={closeForm}>Cancel</button>
      </div>
    </form>
  );
}

/** Why the entry could not be stored, with the possible actions. */
function Trouble({ form: { before, detail, kind, state } }: { form: OpenForm }): VNode | null {
  if (state === 'typing' || state === 'saving') return null;
  return (
    <div class="failure" role="alert">
      <p>{detail}{state === 'failed' ? '' : ' What you typed is still here.'}</p>
      {state === 'conflict' && before && (
        <div class="field-row">
          <button type="button" onClick={() => void openExisting(kind, before)}>Take theirs</button>
          <button type="button" onClick={() => void saveOverTheirs()}>Put mine in its place</button>
        </div>
      )}
    </div>
  );
}

function BergFields({ berg, faults }: { berg: BergForm; faults: OpenForm['faults'] }): VNode {
  const field = (name: keyof BergForm, label: string, unit?: string, placeholder?: string): VNode => (
    <div class={faults[name] ? 'field faulty' : 'field'}>
      <label for={`berg-${name}`}>{label} {unit && <span class="unit">{unit}</span>}</label>
      <div class="field-row">
        <input
          id={`berg-${name}`} type="text" value={berg[name]} placeholder={placeholder} autocomplete="off" spellcheck={false}
          aria-invalid={faults[name] ? true : undefined} aria-describedby={faults[name] ? `fault-berg-${name}` : undefined}
          onInput={(event) => changeBerg({ [name]: event.currentTarget.value })}
        />
        {name === 'place' && <PickPlace />}
      </div>
      {faults[name] && <p class="fault" id={`fault-berg-${name}`}>{faults[name]}</p>}
    </div>
  );
  return (
    <>
      {field('berg_id', 'Name of the berg')}
      {field('place', 'Position', undefined, '69°10.2′N 51°21.0′W')}
      {field('observed', 'Seen at', 'UTC', '2026-11-20 06:00')}
      <div class="field-pair">
        <div class="field">
          <label for="berg-size">Size class</label>
          <select id="berg-size" value={berg.size} onChange={(event) => changeBerg({ size: event.currentTarget.value })}>
            {sizes.map((size) => <option key={size} value={size}>{sizeTitle(size)}</option>)}
          </select>
        </div>
        {field('length_m', 'Length', 'm', 'by size')}
      </div>
      <div class="field-pair">
        {field('draft_m', 'Draft', 'm', 'by length')}
        {field('position_uncertainty_m', 'Position ±', 'm', 'none')}
      </div>
    </>
  );
}

function PickPlace(): VNode {
  const active = tool.value === 'berg';
  return (
    <IconButton
      icon="crosshair" label="Pick the position of the berg on the map" pressed={active}
      onClick={() => {
        tool.value = active ? 'pan' : 'berg';
        drawer.value = undefined;
      }}
    />
  );
}

function ZoneFields({ zone }: { zone: Area }): VNode {
  const change = (part: Partial<Area>): void => changeForm({ zone: { ...zone, ...part }, faults: {}, state: 'typing' });
  const drawing = tool.value === 'zone';
  return (
    <>
      <AreaFields area={zone} id="zone" called="the zone" onChange={change} />
      <button
        type="button" aria-pressed={drawing} class={drawing ? 'primary' : ''}
        onClick={() => {
          tool.value = drawing ? 'pan' : 'zone';
          drawer.value = undefined;
        }}
      >
        <Icon name="polygon" /> Draw the corners again
      </button>
    </>
  );
}
