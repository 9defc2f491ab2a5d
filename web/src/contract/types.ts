/** The server's documents on plans, jobs and probes, field for field. Positions are decimal degrees, longitude first; times are ISO 8601 in UTC. */

import type { namesOfConditions, requestFields } from './request_fields';
import type { Areas, DatasetKind, Link, Position } from './data_types';

type RequestFields = typeof requestFields;

export type Method = RequestFields['method']['words'][number];

/** A file with positions that is sent with a request. */
export interface RouteFile {
  name: string;
  text: string;
}

/** The type of a field's value, from the table of request fields. */
type ValueOf<Told> = Told extends { kind: 'number' | 'whole_number' }
  ? number
  : Told extends { kind: 'boolean' }
    ? boolean
    : Told extends { words: readonly (infer Word)[] }
      ? Word
      : Told extends { kind: 'datasets' }
        ? string | string[]
        : string;

/** Fields whose values are structures. */
interface ShapedInputs {
  from?: Position; // required without goals_file
  to?: Position;
  via?: Position[];
  goals_file?: RouteFile; // replaces `to` and `via`
  vehicle?: string | ({ profile?: string } & Record<string, unknown>);
  spacing_m?: number | [along: number, across: number];
  objective?: 'time' | 'energy' | { time: number; energy: number };
  areas?: Areas;
  under_ice?: Record<string, number | boolean>;
  uncertainty?: Record<string, number | string>;
}

type PlainName = {
  [Name in keyof RequestFields]: Name extends `${string}.${string}` ? never : RequestFields[Name]['kind'] extends 'structure' | 'place' | 'places' ? never : Name;
}[keyof RequestFields];

export type PlanInputs = ShapedInputs & { -readonly [Name in PlainName]?: ValueOf<RequestFields[Name]> };

/** The conditions for evaluating a route: a request without its route. */
export type Conditions = Omit<Pick<PlanInputs, Extract<(typeof namesOfConditions)[number], keyof PlanInputs>>, 'name'> &
  Pick<PlanInputs, 'under_ice'>;

export type EvaluateInputs = Conditions & ({ route: Position[] } | { plan_id: string });

/** A message for the pilot; programs use its code and values. */
export interface Message {
  code: string;
  rank: 'danger' | 'caution' | 'note';
  place: { lon: number; lat: number } | null;
  values: Record<string, number | string | null>;
  text: string;
}

/** The part of an answer with messages. Older servers send only their sentences. */
export interface Told {
  messages?: Message[];
  dangers?: string[];
  warnings: string[];
}

export interface Waypoint {
  index: number;
  lon: number;
  lat: number;
  eta: string;
  wait_s?: number; // hold between the arrival and the next leg; missing in plans of older servers
  leg_m: number | null;
  course_deg: number | null;
  speed_over_ground_m_s: number | null;
  depth_m: number | null;
  current_east_m_s?: number | null; // mean over the leg; missing in plans of older servers
  current_north_m_s?: number | null;
  may_surface?: boolean | null;
  since_last_surfacing_s?: number | null;
  position_error_m?: number | null;
  least_upper_turn_m?: number | null;
  leg_upper_turn_m?: number | null; // deepest upper turn on the leg; missing in plans of older servers
  ice_free_before_m?: number | null; // length of the ice-free route up to here; missing in plans of older servers
  error_without_fix_m?: number | null;
  nearest_ice_m?: number | null; // only if there is ice within 200 km
}

/** A stretch of the leg to a waypoint with ice or icebergs above. */
export interface StretchBelowIce {
  waypoint: number;
  from: [number, number];
  to: [number, number];
  enters: string;
  time_s: number;
  distance_m: number;
}

export interface Surfacing {
  longest_without_surfacing_s: number;
  below_ice_m?: number | null; // sums over the stretches; newer than the rest
  below_ice_s?: number | null;
  below_ice?: StretchBelowIce[] | null;
  unknown_ice_m: number;
  planned: {
    lon: number;
    lat: number;
    time: string;
    position_error_m: number;
    nearest_ice_m?: number | null; // only if there is ice within the position error
  }[];
  escapes: {
    waypoint: number;
    to: [number, number];
    course_deg: number | null;
    distance_m: number;
    time_s: number;
    energy_j?: number;
    way: [number, number][];
    propulsion?: ('buoyancy' | 'thruster')[]; // for each leg of the escape route
  }[];
}

/** One departure of a window. */
export interface Departure {
  departure: string;
  arrival: string | null;
  travel_time_s: number | null;
  energy_j: number | null;
  status: 'ok' | 'infeasible';
  reason: string | null;
  explanation: string | null;
}

export interface Uncertainty {
  members: number;
  arrived: number;
  mean_s: number | null;
  standard_deviation_s: number | null;
  quantiles_s: { p10: number | null; p50: number | null; p90: number | null };
  arrive_before: string | null;
  chance: number | null;
}

/** A route around the other side of a large obstacle, stored as a separate plan. */
export interface Alternative {
  plan_id: string;
  name: string;
  arrival: string;
  travel_time_s: number;
  distance_m: number;
  energy_j: number | null;
  message: Message; // names what the route leads around
}

/** Another value of one input with which a plan would be possible. */
export interface Change {
  input: string;
  from: unknown;
  to: unknown;
  text: string;
  with?: Change[]; // further changes that belong to it
}

export interface DatasetRef {
  id: string;
  kind: DatasetKind;
  name: string;
  sha256: string;
  from?: string; // the steps used, if several runs were joined in time
  until?: string;
}

export interface Plan extends Told {
  plan_id: string;
  name: string;
  status: 'ok';
  method: Method;
  vehicle: string;
  departure: string;
  arrival: string;
  travel_time_s: number;
  distance_m: number;
  surfacing?: Surfacing | null;
  energy_j: number | null;
  energy?: { usable_j: number } | null;
  iceberg_encounters?: number | null;
  departures?: Departure[];
  alternatives?: Alternative[]; // only if requested; best first
  uncertainty?: Uncertainty | null;
  optimality_gap: number | null;
  optimality_gap_reason: string;
  waypoints: Waypoint[];
  search: {
    vertices: number;
    edges: number;
    edge_evaluations: number;
    expansions: number;
    reinsertions: number;
    fifo_violations: number;
    worst_fifo_violation: { lon: number; lat: number; refused: string; opens: string; gain_s: number | null } | null;
    cut_short?: boolean; // missing in plans of older versions
    possible_gain_s?: number | null; // missing in plans of older versions
    seconds: number;
  };
  refinement?: {
    before_s: number;
    after_s: number;
    energy_before_j?: number;
    energy_after_j?: number;
    evaluations: number;
    stopped_by: 'converged' | 'evaluations' | 'time' | 'cancelled';
  } | null;
  encounter_trade?: { weight_s: number; before: { travel_time_s: number; iceberg_encounters: number } } | null;
  leg_trade?: { legs: number; travel_time_s: number }[];
  clearances: { iceberg_m: number | null; iceberg_id?: string | null; land_m: number | null; bottom_m: number | null };
  datasets: DatasetRef[];
  sightings?: { as_of: string; max_age_days: number; oldest: string }; // the sightings of icebergs that counted
  created?: string;
}

export interface Infeasible extends Told {
  status: 'infeasible';
  reason: string;
  at: { lon: number; lat: number };
  when: string;
  explanation: string;
  suggestion: string;
  binding_constraint?: string;
  changes?: Change[];
  changes_cut_short?: boolean; // not all changes were tried
  departures?: Departure[];
  datasets: DatasetRef[];
}

export interface PlanFeature {
  type: 'Feature';
  id: string;
  geometry: { type: 'LineString'; coordinates: Position[] };
  properties: Plan;
}

export interface JobStatus {
  jobID: string;
  type: 'process';
  processID: string;
  status: 'accepted' | 'running' | 'successful' | 'failed' | 'dismissed';
  message: string;
  progress: number;
  stage: string;
  created: string;
  started?: string;
  finished?: string;
  updated: string;
  links: Link[];
}

export interface Reach extends Told {
  status: 'ok' | 'infeasible';
  explanation?: string;
  features: {
    type: 'Feature';
    properties: { hours: number; time: string; area_km2: number };
    geometry: { type: 'MultiPolygon'; coordinates: Position[][][] };
  }[];
}

export type ReachInputs = Conditions & { from: Position; hours: number[] };

export interface PlanResults {
  plan: Plan | Infeasible;
}

export interface EvaluationResults {
  evaluation: Plan | Infeasible; // the plan's id is null
}

export interface MissionPreview extends Told {
  files: { name: string; text: string }[];
}

export interface Probe {
  lon: number;
  lat: number;
  time: string;
  depth_m: number | null;
  depth_reason: string | null;
  land: boolean | null;
  currents: {
    u_m_s: number | null;
    v_m_s: number | null;
    reason: string | null;
    dataset_id: string | null;
    dataset_name: string | null;
    time_before: string | null;
    time_after: string | null;
  };
  ice_concentration: number | null;
  ice_concentration_reason: string | null;
  ice: {
    thickness_m: number | null;
    dataset_id: string | null;
    dataset_name: string | null;
    time_before: string | null;
    time_after: string | null;
  };
  water_level: {
    height_m: number | null; // above the datum; below it if negative
    datum: string | null;
    station: string | null;
    dataset_name: string | null;
    time_before: string | null;
    time_after: string | null;
  };
  icebergs_within: { berg_id: string; distance_m: number; observed: string; size: string }[];
}

export interface Violation {
  pointer: string;
  detail: string;
  code?: string; // code of the rule in the catalogue of messages
  values?: Record<string, number | string>;
}

/** An error response (RFC 9457). */
export interface Problem {
  type: string;
  title: string;
  status: number;
  detail: string;
  errors?: Violation[];
}
