import type { VNode } from 'preact';
import { openExisting, retire } from '../../actions/hand_made';
import type { ZoneFeature } from '../../contract/data_types';
import { formatPosition } from '../../geo/coordinates';
import { bergsByHand, handFault, isBerg, nameOf, newBerg, newZone, openForm, zonesByHand, type HandMade, type HandMadeKind, type OpenForm } from '../../model/hand_made';
import { sizeTitle } from '../../model/ice/icebergs';
import { may } from '../../model/login';
import { drawer } from '../../model/screen';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { ask, tool, view, type Tool } from '../../model/view';
import { Icon, IconButton } from '../common/icon';
import { UndoButtons } from '../common/undo_buttons';
import { goOnByKey } from '../placing_keys';
import { HandMadeForm } from './hand_made_form';

/** Icebergs and zones that users report: add, move, change and retire them, with undo. */
export function HandMadePart(): VNode | null {
  const listed: [HandMadeKind, HandMade][] = [
    ...bergsByHand.value.map((one): [HandMadeKind, HandMade] => ['icebergs', one]),
    ...zonesByHand.value.map((one): [HandMadeKind, HandMade] => ['zones', one]),
  ];
  if (!may('pilot') && listed.length === 0) return null;
  return (
    <section class="hand-made" aria-label="Manual entries">
      <div class="setup-head">
        <h2>Manual entries</h2>
        <UndoButtons />
      </div>
      {handFault.value && <p class="fault" role="alert">{handFault.value}</p>}
      {listed.length > 0 && (
        <ul class="dataset-list" aria-label="Manual entries">
          {listed.map(([kind, one]) => <Row key={`${kind} ${one.id}`} kind={kind} one={one} />)}
        </ul>
      )}
      {openForm.value ? <HandMadeForm form={openForm.value} /> : may('pilot') && <Beginnings />}
    </section>
  );
}

/** Buttons that add an entry, on the map or typed. */
function Beginnings(): VNode {
  const begin = (event: MouseEvent, form: OpenForm | undefined, next: Tool): void => {
    openForm.value = form;
    tool.value = next;
    if (next !== 'pan') drawer.value = undefined;
    goOnByKey(event);
  };
  const drawing = tool.value === 'zone';
  return (
    <>
      <div class="field-row">
        <button type="button" onClick={(event) => begin(event, newBerg(), 'berg')}><Icon name="plus" /> Report an iceberg</button>
      </div>
      <div class="field-row">
        <button type="button" aria-pressed={drawing} class={drawing ? 'primary' : ''} onClick={(event) => begin(event, undefined, drawing ? 'pan' : 'zone')}><Icon name="polygon" /> Draw a zone</button>
        <button type="button" onClick={(event) => begin(event, newZone(squareInView()), 'pan')}><Icon name="plus" /> Type a zone</button>
      </div>
      <p class="hint">Plans avoid these as well as those of imported files. To update an imported berg, report it again under the same name.</p>
    </>
  );
}

/** The corners of a small zone in the middle of the map, as a first outline. */
function squareInView(): [number, number][] {
  const [west, south, east, north] = view.value?.box ?? [-52, 69, -51, 69.2];
  const [x, y] = view.value?.centre ?? [(west + east) / 2, (south + north) / 2];
  const [dx, dy] = [Math.abs(east - west) / 12, (north - south) / 12];
  return [[x - dx, y - dy], [x + dx, y - dy], [x + dx, y + dy], [x - dx, y + dy]];
}

function Row({ kind, one }: { kind: HandMadeKind; one: HandMade }): VNode {
  const name = nameOf(one);
  const place = isBerg(one) ? one.geometry.coordinates : one.geometry.coordinates[0]?.[0];
  const open = openForm.value?.before?.id === one.id && openForm.value.kind === kind;
  return (
    <li class={open ? 'dataset covered' : 'dataset'}>
      <div class="dataset-head">
        <span class="dataset-kind">{isBerg(one) ? `iceberg, ${one.properties.size === 'unknown' ? 'size unknown' : sizeTitle(one.properties.size)}` : one.properties.kind === 'no_go' ? 'zone to keep out of' : 'zone to stay in'}</span>
        <IconButton icon="crosshair" label={`Show ${name} on the map`} onClick={() => { if (place) ask({ do: 'centre', place }); }} />
        <IconButton icon="edit" label={`Change ${name}`} disabled={!may('pilot')} onClick={() => void openExisting(kind, one)} />
        <IconButton icon="trash" label={`Retire ${name}`} disabled={!may('pilot')} onClick={() => void retire(kind, one)} />
      </div>
      <b class="dataset-name">{name}</b>
      <p class="dataset-figures">
        {isBerg(one) && <span>{formatPosition(one.geometry.coordinates, settings.value.coordinates)}</span>}
        {isBerg(one) ? <span>seen {shortTime(Date.parse(one.properties.observed))}</span> : <Extent {...one.properties} />}
      </p>
    </li>
  );
}

function Extent({ from, until, top_m, bottom_m }: ZoneFeature['properties']): VNode {
  const time = (text: string | null, none: string): string => (text ? shortTime(Date.parse(text)) : none);
  return (
    <>
      <span>{from || until ? `${time(from, 'since ever')} – ${time(until, 'for ever')}` : 'at all times'}</span>
      <span>{top_m || bottom_m !== null ? `${top_m ?? 0} m – ${bottom_m === null ? 'sea bed' : `${bottom_m} m`}` : 'at all depths'}</span>
    </>
  );
}
