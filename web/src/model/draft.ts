import { computed, signal } from '@preact/signals';
import type { Position } from '../api/data_types';
import type { Method, RouteFile } from '../api/types';
import { readPosition } from './position';
import type { Area } from './area';
import { severalIn } from './data_choice';
import { begin, record, redo, undo } from './history';

/**
 * The set-up as a person types it: texts until they are sent. Numbers left empty take the server's default. A name with a
 * dot is a member of a member of the request.
 */
export interface Draft {
  from: string;
  to: string;
  via: string;
  via_order: 'given' | 'best';
  goals_file: RouteFile; // without a name there is none; else it takes the place of `to` and `via`
  route_name: string; // the one to take from that file
  depart: string;
  depart_until: string;
  depart_step: string; // hours
  arrive_by: string;
  vehicle: string;
  'vehicle.depth_rating_m': string;
  'vehicle.minimum_working_depth_m': string;
  'vehicle.buoyancy_cm3': string;
  'vehicle.hotel_w': string;
  'vehicle.surfacing_interval_s': string; // hours
  'vehicle.surfacing_j': string; // kilojoules
  'vehicle.battery_reserve_share': string; // percent
  'vehicle.max_waypoints_per_list': string;
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
  spacing_m: string; // or two: along × across
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
  'uncertainty.objective': 'first' | 'mean' | 'quantile'; // first: planned in the first member, judged in all
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
  from: '', to: '', via: '', via_order: 'given', goals_file: { name: '', text: '' }, route_name: '', depart: '', depart_until: '', depart_step: '3',
  arrive_by: '', vehicle: '', 'vehicle.depth_rating_m': '', 'vehicle.minimum_working_depth_m': '', 'vehicle.buoyancy_cm3': '',
  'vehicle.hotel_w': '', 'vehicle.surfacing_interval_s': '', 'vehicle.surfacing_j': '', 'vehicle.battery_reserve_share': '',
  'vehicle.max_waypoints_per_list': '', name: '',
  margin_m: '500', objective: 'time', 'objective.time': '1', 'objective.energy': '1', method: 'astar', speed_m_s: '', dive_depth_m: '',
  pitch_deg: '', climb_to_m: '', altimeter_margin_m: '', battery_j: '', battery_start_share: '', require_battery: false,
  thruster: 'auto', spacing_m: '', sectors: '3', max_waypoints: '', max_leg_m: '', refine: true, refine_seconds: '',
  optimality_gap: true, steady: false, areas: [], icebergs_drift: true, max_inflation_m: '', max_sighting_age_days: '',
  pass_under_icebergs: false, keel_clearance_m: '', draft_uncertainty: '', encounter_weight_s: '', max_loiter_s: '',
  'under_ice.max_concentration_to_surface': '', 'under_ice.margin_below_ice_m': '', 'under_ice.draft_if_unknown_m': '',
  'under_ice.max_time_without_surfacing_s': '', 'under_ice.surfacing_interval_s': '', 'under_ice.dead_reckoning_share': '',
  'under_ice.current_uncertainty_m_s': '', 'under_ice.escape_plan': false, 'uncertainty.members': '',
  'uncertainty.current_error_m_s': '0.05', 'uncertainty.length_scale_m': '30', 'uncertainty.time_scale_s': '24',
  'uncertainty.seed': '', 'uncertainty.objective': 'first', 'uncertainty.quantile': '', 'uncertainty.arrive_before': '',
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
