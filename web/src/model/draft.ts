import { computed, signal } from '@preact/signals';
import type { Change, Method, PlanInputs, Position, Violation } from '../api/types';
import { parsePosition } from '../geo/coordinates';
import { areasInputs, faultOfAreas, type Area } from './area';
import { begin, record, redo, undo } from './history';
import { fieldOf, isoOf, parseTime } from './time';

/**
 * The set-up as a person types it: texts until they are sent. Numbers left empty take the server's default. A name with a
 * dot is a member of a member of the request.
 */
export interface Draft {
  from: string;
  to: string;
  via: string;
  via_order: 'given' | 'best';
  depart: string;
  depart_until: string;
  depart_step: string; // hours
  arrive_by: string;
  vehicle: string;
  name: string;
  margin_m: string;
  objective: 'time' | 'energy' | 'both';
  'objective.time': string; // weight of a second, with both
  'objective.energy': string; // weight of a joule, with both
  method: Method;
  speed_m_s: string;
  dive_depth_m: string;
  pitch_deg: string;
  climb_to_m: string;
  altimeter_margin_m: string;
  battery_j: string; // megajoules
  battery_start_share: string; // percent
  require_battery: boolean;
  thruster: 'auto' | 'on' | 'off';
  spacing_m: string;
  sectors: string;
  max_waypoints: string;
  max_leg_m: string; // kilometres
  refine: boolean;
  refine_seconds: string;
  optimality_gap: boolean;
  steady: boolean;
  areas: Area[];
  icebergs_drift: boolean;
  max_inflation_m: string;
  max_sighting_age_days: string;
  pass_under_icebergs: boolean;
  keel_clearance_m: string;
  draft_uncertainty: string; // percent
  encounter_weight_s: string; // hours
  max_loiter_s: string; // hours
  'under_ice.max_concentration_to_surface': string; // percent
  'under_ice.margin_below_ice_m': string;
  'under_ice.draft_if_unknown_m': string;
  'under_ice.max_time_without_surfacing_s': string; // hours
  'under_ice.surfacing_interval_s': string; // hours
  'under_ice.dead_reckoning_share': string; // percent
  'under_ice.current_uncertainty_m_s': string;
  'under_ice.escape_plan': boolean;
  'uncertainty.members': string;
  'uncertainty.current_error_m_s': string;
  'uncertainty.length_scale_m': string; // kilometres
  'uncertainty.time_scale_s': string; // hours
  'uncertainty.seed': string;
  'uncertainty.objective': 'mean' | 'quantile';
  'uncertainty.quantile': string; // percent
  'uncertainty.arrive_before': string;
  currents: string;
  bathymetry: string;
  icebergs: string;
  ice: string;
  coastline: string;
  tides: string;
  tides_mode: 'add' | 'only';
  wind: string;
  zones: string;
  icebergs_as_of: string;
}

export const emptyDraft: Draft = {
  from: '', to: '', via: '', via_order: 'given', depart: '', depart_until: '', depart_step: '3', arrive_by: '', vehicle: '', name: '',
  margin_m: '500', objective: 'time', 'objective.time': '1', 'objective.energy': '1', method: 'astar', speed_m_s: '', dive_depth_m: '',
  pitch_deg: '', climb_to_m: '', altimeter_margin_m: '', battery_j: '', battery_start_share: '', require_battery: false,
  thruster: 'auto', spacing_m: '', sectors: '3', max_waypoints: '', max_leg_m: '', refine: true, refine_seconds: '',
  optimality_gap: true, steady: false, areas: [], icebergs_drift: true, max_inflation_m: '', max_sighting_age_days: '',
  pass_under_icebergs: false, keel_clearance_m: '', draft_uncertainty: '', encounter_weight_s: '', max_loiter_s: '',
  'under_ice.max_concentration_to_surface': '', 'under_ice.margin_below_ice_m': '', 'under_ice.draft_if_unknown_m': '',
  'under_ice.max_time_without_surfacing_s': '', 'under_ice.surfacing_interval_s': '', 'under_ice.dead_reckoning_share': '',
  'under_ice.current_uncertainty_m_s': '', 'under_ice.escape_plan': false, 'uncertainty.members': '',
  'uncertainty.current_error_m_s': '0.05', 'uncertainty.length_scale_m': '30', 'uncertainty.time_scale_s': '24',
  'uncertainty.seed': '', 'uncertainty.objective': 'mean', 'uncertainty.quantile': '', 'uncertainty.arrive_before': '',
  currents: 'newest', bathymetry: 'newest', ice: 'newest', icebergs: 'newest', coastline: 'newest', tides: 'none', tides_mode: 'add',
  wind: 'newest', zones: 'all', icebergs_as_of: '',
};

export type Field = keyof Draft;
export type Faults = Partial<Record<Field, string>>;

/** Every state of the set-up since the page was opened; typing in one field is one step. */
const history = signal(begin(emptyDraft));
let typingIn = '';

export const draft = computed(() => history.value.now);
export const canUndoDraft = computed(() => history.value.past.length > 0);
export const canRedoDraft = computed(() => history.value.future.length > 0);

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
  const next = { ...draft.peek(), ...part };
  const fields = Object.keys(part).join();
  history.value = fields === typingIn ? { ...history.peek(), now: next, future: [] } : record(history.peek(), next);
  typingIn = fields;
  const rest = { ...faults.value };
  for (const field of Object.keys(part) as Field[]) rest[field] = undefined;
  faults.value = rest;
}

/** Fills in what a person has not asked for: nothing to undo. */
export function fill(part: Partial<Draft>): void {
  history.value = { ...history.peek(), now: { ...draft.peek(), ...part } };
}

export function undoDraft(): void {
  history.value = undo(history.peek());
  typingIn = '';
}

export function redoDraft(): void {
  history.value = redo(history.peek());
  typingIn = '';
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

/** Fields that hold numbers, and how many of the request's unit make one of the field's. */
const numberFields = {
  margin_m: 1, 'objective.time': 1, 'objective.energy': 1, speed_m_s: 1, dive_depth_m: 1, pitch_deg: 1, climb_to_m: 1,
  altimeter_margin_m: 1, battery_j: 1e6, battery_start_share: 0.01, spacing_m: 1, sectors: 1, max_waypoints: 1, max_leg_m: 1000,
  refine_seconds: 1, max_inflation_m: 1, max_sighting_age_days: 1, keel_clearance_m: 1, draft_uncertainty: 0.01,
  encounter_weight_s: 3600, max_loiter_s: 3600, 'under_ice.max_concentration_to_surface': 0.01, 'under_ice.margin_below_ice_m': 1,
  'under_ice.draft_if_unknown_m': 1, 'under_ice.max_time_without_surfacing_s': 3600, 'under_ice.surfacing_interval_s': 3600,
  'under_ice.dead_reckoning_share': 0.01, 'under_ice.current_uncertainty_m_s': 1, 'uncertainty.members': 1,
  'uncertainty.current_error_m_s': 1, 'uncertainty.length_scale_m': 1000, 'uncertainty.time_scale_s': 3600, 'uncertainty.seed': 1,
  'uncertainty.quantile': 0.01,
} as const;
type NumberField = keyof typeof numberFields;
const numberFieldNames = Object.keys(numberFields) as NumberField[];

/** Fields that hold instants in UTC. */
const timeFields = ['depart', 'depart_until', 'arrive_by', 'icebergs_as_of', 'uncertainty.arrive_before'] as const;

/** Fields that are sent only where they differ from what the server takes anyway. */
const sentWhenChanged = [
  'via_order', 'objective', 'thruster', 'require_battery', 'optimality_gap', 'icebergs_drift', 'pass_under_icebergs',
  'under_ice.escape_plan', 'uncertainty.objective', 'tides', 'wind', 'zones',
] as const;

/** The request a draft stands for, or every fault that keeps it from being sent. */
export function inputsOf(form: Draft): { inputs: PlanInputs } | { faults: Faults } {
  const found: Faults = {};
  const from = parsePosition(form.from);
  const to = parsePosition(form.to);
  if (!from.ok) found.from = from.fault;
  if (!to.ok) found.to = to.fault;
  const via = placesIn(form.via);
  if (via.fault) found.via = via.fault;
  const areaFault = faultOfAreas(form.areas);
  if (areaFault) found.areas = areaFault;

  const values: Partial<Record<Field, number | string | boolean>> = {};
  const isCertain = form['uncertainty.members'].trim() === '';
  const isLeftOut = (field: Field): boolean =>
    (isCertain && field.startsWith('uncertainty.')) || (form.objective !== 'both' && field.startsWith('objective.'));
  for (const field of timeFields) {
    if (form[field].trim() === '' || isLeftOut(field)) continue;
    const time_ms = parseTime(form[field]);
    if (time_ms === undefined) found[field] = 'Write the time in UTC as 2026-11-20 06:00.';
    else values[field] = isoOf(time_ms);
  }
  if (form.depart.trim() === '' && form.arrive_by.trim() === '') found.depart = 'Write the time in UTC as 2026-11-20 06:00.';

  for (const field of numberFieldNames) {
    if (form[field].trim() === '' || isLeftOut(field)) continue;
    const value = numberIn(form[field]);
    if (value === undefined) found[field] = 'Write a number.';
    else values[field] = Number((value * numberFields[field]).toPrecision(12));
  }
  if (form.depart_until.trim() !== '') {
    const step_h = numberIn(form.depart_step);
    if (step_h === undefined || step_h <= 0) found.depart_step = 'Write a number of hours.';
    else values.depart_step = `PT${Math.round(60 * step_h)}M`;
  }
  if (form.tides !== 'none') values.tides_mode = form.tides_mode;
  for (const field of sentWhenChanged) {
    const isPlain = !(field === 'objective' && form.objective === 'both');
    if (isPlain && !isLeftOut(field) && form[field] !== emptyDraft[field]) values[field] = form[field];
  }
  if (!from.ok || !to.ok || Object.keys(found).length > 0) return { faults: found };

  return {
    inputs: {
      from: rounded(from.value),
      to: rounded(to.value),
      ...(via.places.length > 0 ? { via: via.places.map(rounded) } : {}),
      ...(form.vehicle ? { vehicle: form.vehicle } : {}),
      ...(form.name.trim() ? { name: form.name.trim() } : {}),
      ...nested(values),
      ...(form.areas.length > 0 ? { areas: areasInputs(form.areas) } : {}),
      method: form.method,
      refine: form.refine,
      steady: form.steady,
      currents: form.currents,
      bathymetry: form.bathymetry,
      icebergs: form.icebergs,
      ice: form.ice,
      coastline: form.coastline,
    },
  };
}

/** Fields with a dot as members of members. */
function nested(values: Partial<Record<Field, number | string | boolean>>): Partial<PlanInputs> {
  const inputs: Record<string, unknown> = {};
  for (const [field, value] of Object.entries(values)) {
    const [outer = '', inner] = field.split('.');
    inputs[outer] = inner === undefined ? value : { ...(inputs[outer] as object | undefined), [inner]: value };
  }
  return inputs;
}

/** Seven decimals are a centimetre. */
function rounded([lon, lat]: Position): Position {
  return [Math.round(lon * 1e7) / 1e7, Math.round(lat * 1e7) / 1e7];
}

const fieldNames = Object.keys(emptyDraft) as Field[];
const aliases: Record<string, Field> = { departure: 'depart', start: 'from', goal: 'to', iceberg_margin: 'margin_m', uncertainty: 'uncertainty.members' };

/** The field that holds what a JSON pointer (or the name of an input) names. */
function fieldAt(pointer: string): Field | undefined {
  const words = pointer.split('/').filter((word) => word !== '' && word !== 'inputs');
  const [outer = '', inner = ''] = words;
  return fieldNames.find((name) => name === `${outer}.${inner}`) ?? fieldNames.find((name) => name === outer) ?? aliases[outer];
}

/** Puts the server's violations beside the fields their JSON pointers name. */
export function sortViolations(violations: Violation[]): { faults: Faults; general: string[] } {
  const sorted: Faults = {};
  const general: string[] = [];
  for (const { pointer, detail } of violations) {
    const field = fieldAt(pointer);
    const text = detail.charAt(0).toUpperCase() + detail.slice(1);
    const word = pointer.replace(/^\/?(inputs\/)?/, '');
    if (field) sorted[field] = sorted[field] ? `${sorted[field]} ${text}` : text;
    else general.push(word ? `${word}: ${text}` : text);
  }
  return { faults: sorted, general };
}

/** A change that the server proposes, as an edit of the set-up; undefined where the set-up has no field for it. */
export function editFor({ input, to }: Change, form: Draft): Partial<Draft> | undefined {
  const field = fieldAt(input);
  if (!field) return undefined;
  if (field === 'via') return viaEdit(input, to, form);
  if (isPosition(to)) return { [field]: exact(to) };
  if (typeof to === 'number') return field in numberFields ? { [field]: String(Number((to / numberFields[field as NumberField]).toPrecision(8))) } : undefined;
  if (typeof to === 'boolean' && typeof emptyDraft[field] === 'boolean') return { [field]: to };
  if (typeof to !== 'string' || typeof emptyDraft[field] !== 'string') return undefined;
  const time_ms = (timeFields as readonly Field[]).includes(field) ? Date.parse(to) : undefined;
  return { [field]: time_ms === undefined ? to : time_ms % 60_000 === 0 ? fieldOf(time_ms) : isoOf(time_ms) };
}

function viaEdit(input: string, to: unknown, form: Draft): Partial<Draft> | undefined {
  const lines = form.via.split('\n').filter((line) => line.trim() !== '');
  const index = Number(input.split('/')[1]);
  if (!isPosition(to) || !(index in lines)) return undefined;
  return { via: lines.map((line, i) => (i === index ? exact(to) : line)).join('\n') };
}

const isPosition = (value: unknown): value is Position =>
  Array.isArray(value) && value.length === 2 && value.every((part) => typeof part === 'number');

/** To the centimetre: a place moved just clear of something must not fall back into it. */
const exact = ([lon, lat]: Position): string => `${Number(lat.toFixed(7))}, ${Number(lon.toFixed(7))}`;
