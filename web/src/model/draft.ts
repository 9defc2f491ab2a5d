import { signal } from '@preact/signals';
import type { Method, PlanInputs, Violation } from '../api/types';
import { parsePosition } from '../geo/coordinates';
import type { Position } from '../api/types';
import { isoOf, parseTime } from './time';

/** The set-up as a person types it: texts until they are sent. Numbers left empty take the server's default. */
export interface Draft {
  from: string;
  to: string;
  via: string;
  depart: string;
  vehicle: string;
  name: string;
  margin_m: string;
  method: Method;
  speed_m_s: string;
  dive_depth_m: string;
  spacing_m: string;
  sectors: string;
  max_waypoints: string;
  refine: boolean;
  steady: boolean;
  currents: string;
  bathymetry: string;
  icebergs: string;
  ice: string;
  coastline: string;
  icebergs_as_of: string;
}

export const emptyDraft: Draft = {
  from: '', to: '', via: '', depart: '', vehicle: '', name: '', margin_m: '500', method: 'astar', speed_m_s: '', dive_depth_m: '',
  spacing_m: '', sectors: '3', max_waypoints: '', refine: true, steady: false, currents: 'newest', bathymetry: 'newest',
  ice: 'newest', icebergs: 'newest', coastline: 'newest', icebergs_as_of: '',
};

export type Field = keyof Draft;
export type Faults = Partial<Record<Field, string>>;

export const draft = signal<Draft>(emptyDraft);

/** What is wrong, beside the field it is wrong in; `generalFaults` belong to no field. */
export const faults = signal<Faults>({});
export const generalFaults = signal<string[]>([]);

/** How often a request was found faulty: each time the focus goes to the first fault. */
export const faultyAttempts = signal(0);

export function refuse(found: Faults, general: string[] = []): void {
  faults.value = found;
  generalFaults.value = general;
  faultyAttempts.value += 1;
}

export function edit(part: Partial<Draft>): void {
  draft.value = { ...draft.value, ...part };
  const rest = { ...faults.value };
  for (const field of Object.keys(part) as Field[]) rest[field] = undefined;
  faults.value = rest;
}

/** The place in a position field, where it can be read. */
export function placeIn(text: string): Position | undefined {
  const parsed = parsePosition(text);
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
    const parsed = parsePosition(line);
    if (!parsed.ok) return { places, fault: `Line ${places.length + 1}: ${parsed.fault}` };
    places.push(parsed.value);
  }
  return { places };
}

const numberFields = ['margin_m', 'speed_m_s', 'dive_depth_m', 'spacing_m', 'sectors', 'max_waypoints'] as const;

/** The request a draft stands for, or every fault that keeps it from being sent. */
export function inputsOf(form: Draft): { inputs: PlanInputs } | { faults: Faults } {
  const found: Faults = {};
  const from = parsePosition(form.from);
  const to = parsePosition(form.to);
  if (!from.ok) found.from = from.fault;
  if (!to.ok) found.to = to.fault;
  const via = placesIn(form.via);
  if (via.fault) found.via = via.fault;

  const depart_ms = parseTime(form.depart);
  if (depart_ms === undefined) found.depart = 'Write the time in UTC as 2026-11-20 06:00.';
  const asOf_ms = form.icebergs_as_of.trim() === '' ? undefined : parseTime(form.icebergs_as_of);
  if (form.icebergs_as_of.trim() !== '' && asOf_ms === undefined) found.icebergs_as_of = 'Write the time in UTC as 2026-11-20 06:00.';

  const numbers: Partial<Record<(typeof numberFields)[number], number>> = {};
  for (const field of numberFields) {
    if (form[field].trim() === '') continue;
    const value = numberIn(form[field]);
    if (value === undefined) found[field] = 'Write a number.';
    else numbers[field] = value;
  }
  if (!from.ok || !to.ok || depart_ms === undefined || Object.keys(found).length > 0) return { faults: found };

  return {
    inputs: {
      from: rounded(from.value),
      to: rounded(to.value),
      ...(via.places.length > 0 ? { via: via.places.map(rounded) } : {}),
      depart: isoOf(depart_ms),
      ...(form.vehicle ? { vehicle: form.vehicle } : {}),
      ...(form.name.trim() ? { name: form.name.trim() } : {}),
      ...numbers,
      method: form.method,
      refine: form.refine,
      steady: form.steady,
      currents: form.currents,
      bathymetry: form.bathymetry,
      icebergs: form.icebergs,
      ice: form.ice,
      coastline: form.coastline,
      ...(asOf_ms !== undefined ? { icebergs_as_of: isoOf(asOf_ms) } : {}),
    },
  };
}

/** Seven decimals are a centimetre. */
function rounded([lon, lat]: Position): Position {
  return [Math.round(lon * 1e7) / 1e7, Math.round(lat * 1e7) / 1e7];
}

const fieldNames = Object.keys(emptyDraft) as Field[];
const aliases: Record<string, Field> = { departure: 'depart', start: 'from', goal: 'to', iceberg_margin: 'margin_m' };

/** Puts the server's violations beside the fields their JSON pointers name. */
export function sortViolations(violations: Violation[]): { faults: Faults; general: string[] } {
  const sorted: Faults = {};
  const general: string[] = [];
  for (const { pointer, detail } of violations) {
    const words = pointer.split('/').filter((word) => word !== '' && word !== 'inputs');
    const word = words[0] ?? '';
    const field = aliases[word] ?? fieldNames.find((name) => name === word);
    const text = detail.charAt(0).toUpperCase() + detail.slice(1);
    if (field) sorted[field] = sorted[field] ? `${sorted[field]} ${text}` : text;
    else general.push(word ? `${word}: ${text}` : text);
  }
  return { faults: sorted, general };
}
