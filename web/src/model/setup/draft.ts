import { computed, signal } from '@preact/signals';
import type { Position } from '../../contract/data_types';
import type { Method, RouteFile } from '../../contract/types';
import { readPosition } from '../position';
import type { Area } from '../area';
import { severalIn } from './data_choice';
import { checkFields, formOf, isUsual, numberFields, timeFields, type CheckField, type NumberField, type TimeField } from '../fields';
import { remember } from '../undo';

/**
 * The set-up as a person types it: texts in the units of the form, until they are sent. An empty number takes the server's default. A
 * name with a dot is a member of an object of the request.
 */
export type Draft = Record<NumberField, string> & Record<CheckField, boolean> & Record<TimeField, string> & Others;

/** The fields that are no number, no switch and no instant. */
interface Others {
  from: string;
  to: string;
  via: string;
  via_order: 'given' | 'best';
  goals_file: RouteFile; // an empty name: no file; else it replaces `to` and `via`
  route_name: string; // which route of that file to take
  depart_step: string; // hours
  vehicle: string;
  name: string;
  objective: 'time' | 'energy' | 'both';
  method: Method;
  thruster: 'auto' | 'on' | 'off';
  spacing_m: string; // or two: along × across
  areas: Area[];
  'uncertainty.objective': 'first' | 'mean' | 'quantile'; // first: planned in the first member, judged in all
  currents: string;
  bathymetry: string;
  icebergs: string;
  ice: string;
  coastline: string;
  tides: string;
  tides_mode: 'add' | 'only';
  wind: string;
  zones: string;
}

const filled = <Name extends string, Value>(names: Name[], value: (name: Name) => Value): Record<Name, Value> =>
  Object.fromEntries(names.map((name) => [name, value(name)])) as Record<Name, Value>;

export const emptyDraft: Draft = {
  ...filled([...numberFields, ...timeFields], () => ''),
  ...filled(checkFields, isUsual),
  from: '', to: '', via: '', via_order: 'given', goals_file: { name: '', text: '' }, route_name: '', depart_step: '3', vehicle: '', name: '',
  margin_m: '500', objective: 'time', 'objective.time': '1', 'objective.energy': '1', method: 'astar', thruster: 'auto', spacing_m: '',
  sectors: '3', areas: [], 'uncertainty.current_error_m_s': '0.05', 'uncertainty.length_scale_m': '30', 'uncertainty.time_scale_s': '24',
  'uncertainty.objective': 'first', currents: 'newest', bathymetry: 'newest', ice: 'newest', icebergs: 'newest', coastline: 'newest',
  tides: 'none', tides_mode: 'add', wind: 'newest', zones: 'all',
};

export type Field = keyof Draft;
export type Faults = Partial<Record<Field, string>>;

const now = signal(emptyDraft);
export const draft = computed(() => now.value);

/** Faults by the field that they belong to; `generalFaults` belong to none. */
export const faults = signal<Faults>({});
export const generalFaults = signal<string[]>([]);

/** How many requests were found faulty. Each time it grows the focus moves to the first fault. */
export const faultyAttempts = signal(0);

export function refuse(found: Faults, general: string[] = []): void {
  faults.value = found;
  generalFaults.value = general;
  faultyAttempts.value += 1;
}

const faultOf = (text: string): string | undefined => {
  const parsed = readPosition(text);
  return parsed.ok ? undefined : parsed.fault;
};

/** Says at once what is wrong with a position that was typed, and leaves its text. Other fields are judged when a plan is asked for. */
export function checkPlaces(field: Field): void {
  if (field !== 'from' && field !== 'to' && field !== 'via') return;
  const text = draft.peek()[field];
  const fault = text.trim() === '' ? undefined : field === 'via' ? placesIn(text).fault : faultOf(text);
  if (fault !== undefined) faults.value = { ...faults.peek(), [field]: fault };
}

/** Changes fields and clears their faults. `typing`: the text field that somebody is typing in. */
export function edit(part: Partial<Draft>, typing?: string): void {
  const before = draft.peek();
  const old = Object.fromEntries(fieldsIn(part).map((field) => [field, before[field]]));
  const put = (fields: Partial<Draft>): void => {
    fill(fields);
    faults.value = { ...faults.value, ...Object.fromEntries(fieldsIn(fields).map((field) => [field, undefined])) };
  };
  put(part);
  remember({ title: titleOfEdit(part, before), back: () => put(old), again: () => put(part), ...(typing === undefined ? {} : { typing: `set-up ${typing}` }) });
}

const fieldsIn = (part: Partial<Draft>): Field[] => Object.keys(part) as Field[];

function titleOfEdit(part: Partial<Draft>, { areas }: Draft): string {
  const [field, ...others] = fieldsIn(part);
  if (field === undefined || others.length > 0) return 'changing the set-up';
  if (field === 'via') return 'changing the via points';
  if (field !== 'areas') return `changing “${formOf(field).label || field}”`;
  const more = (part.areas?.length ?? 0) - areas.length;
  return `${more > 0 ? 'adding' : more < 0 ? 'removing' : 'changing'} an area`;
}

/** Fills in fields that a person has not set. This cannot be undone. */
export function fill(part: Partial<Draft>): void {
  now.value = { ...draft.peek(), ...part };
}

/** The position in a field; undefined where it cannot be read. */
export function placeIn(text: string): Position | undefined {
  const parsed = readPosition(text);
  return parsed.ok ? parsed.value : undefined;
}

/** The number in a field, with a decimal point or comma. */
export function numberIn(text: string): number | undefined {
  const value = Number(text.trim().replace(',', '.'));
  return text.trim() !== '' && Number.isFinite(value) ? value : undefined;
}

/** Places between start and goal: one on each line. */
export function placesIn(text: string): { places: Position[]; fault?: string } {
  const places: Position[] = [];
  for (const line of text.split('\n')) {
    if (line.trim() === '') continue;
    const parsed = readPosition(line);
    if (!parsed.ok) return { places, fault: `Line ${places.length + 1}: ${parsed.fault}` };
    places.push(parsed.value);
  }
  return { places };
}

/** Whether the plan is judged in several currents: members of an ensemble, or drawn from an error model. */
export const isEnsemble = (form: Draft): boolean => (severalIn(form.currents)?.length ?? 0) > 1;
export const hasGoalsFile = (form: Draft): boolean => form.goals_file.name !== '';
