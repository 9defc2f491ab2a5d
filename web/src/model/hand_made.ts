import { computed, signal } from '@preact/signals';
import type { IcebergFeature, NewFeature, Position, ZoneFeature } from '../contract/data_types';
import { editablePosition } from '../geo/coordinates';
import { readPosition } from './position';
import { areaOf, areasInputs, faultOfAreas, newArea, type Area } from './area';
import { time_ms } from './clock';
import { byHand } from './datasets';
import { fieldOf, isoOf, parseTime } from './time';

/** Manual entries: icebergs and zones that users report. Each is a feature that can be changed. */
export type HandMadeKind = 'icebergs' | 'zones';
export type HandMade = IcebergFeature | ZoneFeature;

export const bergsByHand = signal<IcebergFeature[]>([]);

/** Every stored zone, those from files included. Plans obey all of them. */
export const zones = signal<ZoneFeature[]>([]);
export const zonesByHand = computed(() => zones.value.filter(({ properties }) => properties.dataset_id === byHand('zones')));

/** The form of one berg, as it is typed. */
export interface BergForm {
  berg_id: string;
  place: string;
  observed: string;
  size: string;
  length_m: string;
  draft_m: string;
  position_uncertainty_m: string;
}

/**
 * The entry being added or changed. `tag` is the entity tag of the version that the change began from. The server
 * refuses the change if another user has changed the entry since.
 */
export interface OpenForm {
  kind: HandMadeKind;
  before?: HandMade;
  tag?: string;
  berg?: BergForm;
  zone?: Area;
  faults: Partial<Record<keyof BergForm | 'zone', string>>;
  state: 'typing' | 'saving' | 'conflict' | 'removed' | 'failed';
  detail?: string;
}

export const openForm = signal<OpenForm | undefined>(undefined);

export function changeForm(part: Partial<OpenForm>): void {
  if (openForm.value) openForm.value = { ...openForm.value, ...part };
}

export const changeBerg = (part: Partial<BergForm>): void => {
  const form = openForm.value;
  if (!form?.berg) return;
  const settled = Object.fromEntries(Object.keys(part).map((field) => [field, undefined]));
  openForm.value = { ...form, berg: { ...form.berg, ...part }, faults: { ...form.faults, ...settled } };
};

const textOf = (value: number | null): string => (value === null ? '' : String(value));

export const bergForm = ({ geometry, properties }: IcebergFeature): BergForm => ({
  berg_id: properties.berg_id,
  place: editablePosition(geometry.coordinates),
  observed: fieldOf(Date.parse(properties.observed)),
  size: properties.size,
  length_m: textOf(properties.length_m),
  draft_m: textOf(properties.draft_m),
  position_uncertainty_m: textOf(properties.position_uncertainty_m),
});

/** A new iceberg, seen now, or at the clock's time if that is in the past. */
export const newBerg = (place = ''): OpenForm => ({
  kind: 'icebergs', faults: {}, state: 'typing',
  berg: {
    berg_id: freeName(), place, observed: fieldOf(Math.min(Date.now(), time_ms.peek())), size: 'unknown', length_m: '', draft_m: '',
    position_uncertainty_m: '',
  },
});

export const newZone = (corners: Position[]): OpenForm => ({
  kind: 'zones', faults: {}, state: 'typing', zone: { ...newArea(corners, 1), name: `Zone ${zonesByHand.peek().length + 1}` },
});

/** "sighted-3": one past the highest number in use. */
function freeName(): string {
  const numbers = bergsByHand.peek().map(({ properties }) => Number(/^sighted-(\d+)$/.exec(properties.berg_id)?.[1] ?? 0));
  return `sighted-${Math.max(0, ...numbers) + 1}`;
}

export function formOf(kind: HandMadeKind, before: HandMade, tag: string | undefined): OpenForm {
  const common = { kind, before, ...(tag === undefined ? {} : { tag }), faults: {}, state: 'typing' as const };
  return isBerg(before) ? { ...common, berg: bergForm(before) } : { ...common, zone: areaOf(before) };
}

export const isBerg = (feature: HandMade): feature is IcebergFeature => feature.geometry.type === 'Point';

export const nameOf = (feature: HandMade): string => (isBerg(feature) ? feature.properties.berg_id : feature.properties.name || 'Zone without a name');

/** The feature described by a form, or every fault beside its field. */
export function featureOf({ before, berg, zone }: OpenForm): { feature: NewFeature } | { faults: OpenForm['faults'] } {
  if (berg) return bergFeature(berg, before && isBerg(before) ? before : undefined);
  if (!zone) return { faults: { zone: 'Draw the zone or type its corners.' } };
  const fault = faultOfAreas([zone]) ?? (zone.corners.length < 3 ? 'A zone needs three corners or more.' : undefined);
  const [feature] = areasInputs([zone]).features;
  if (fault || !feature) return { faults: { zone: fault ?? '' } };
  const old = before && !isBerg(before) ? before : undefined;
  const sameCorners = old && JSON.stringify(areaOf(old).corners) === JSON.stringify(zone.corners);
  return { feature: sameCorners ? { ...feature, geometry: old.geometry } : feature };
}

const lengths = ['length_m', 'draft_m', 'position_uncertainty_m'] as const;

function bergFeature(form: BergForm, before: IcebergFeature | undefined): { feature: NewFeature } | { faults: OpenForm['faults'] } {
  const faults: OpenForm['faults'] = {};
  if (form.berg_id.trim() === '') faults.berg_id = 'Give it a name, the same in each of its sightings.';
  const place = readPosition(form.place);
  if (!place.ok) faults.place = place.fault;
  const observed_ms = parseTime(form.observed);
  if (observed_ms === undefined) faults.observed = 'Write the time in UTC as 2026-11-20 06:00.';
  const known: Record<string, number> = {};
  for (const name of lengths) {
    if (form[name].trim() === '') continue;
    const value = Number(form[name].trim().replace(',', '.'));
    if (!Number.isFinite(value) || value < 0) faults[name] = 'Write metres, 0 or more.';
    else known[name] = value;
  }
  if (!place.ok || observed_ms === undefined || Object.keys(faults).length > 0) return { faults };

  // Values that were not touched are sent as they were stored, because a field shows a place only to 2 m and a time to the
  // minute.
  const old = before && bergForm(before);
  return {
    feature: {
      type: 'Feature',
      geometry: { type: 'Point', coordinates: before && old?.place === form.place ? before.geometry.coordinates : place.value },
      properties: {
        berg_id: form.berg_id.trim(),
        observed: before && old?.observed === form.observed ? before.properties.observed : isoOf(observed_ms),
        size: form.size, ...known,
        ...(before?.properties.shape ? { shape: before.properties.shape } : {}),
        method: before?.properties.method || 'by hand',
      },
    },
  };
}

/** A change that was made, and how to undo it: `before` is empty where it added something, `after` where it removed something. */
export interface HandChange {
  kind: HandMadeKind;
  id: string;
  tag: string | undefined;
  title: string;
  before?: NewFeature;
  after?: NewFeature;
}

export const handChanges = signal<{ done: HandChange[]; undone: HandChange[] }>({ done: [], undone: [] });

/** The same feature under its new id, after it was stored again. */
export function renumber(changes: HandChange[], from: string, to: string, kind: HandMadeKind, tag: string | undefined): HandChange[] {
  return changes.map((change) => (change.kind === kind && change.id === from ? { ...change, id: to, tag } : change));
}

export const handFault = signal<string | undefined>(undefined);
