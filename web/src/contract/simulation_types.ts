import type { DatasetRef, Told } from './types';

/** Documents of simulated flights, with the fields that the page uses. */

export interface SimulateInputs {
  plan_id: string;
  runs?: number;
  seed?: number;
  tracks?: number;
  avoidance?: boolean;
  current_error?: { rms_m_s: number };
  name?: string;
}

export type Interval = [low: number, high: number];

export interface Distribution {
  runs: number;
  mean: number;
  mean_interval_95: Interval | null;
  standard_deviation: number | null;
  quantiles: { share: number; value: number; interval_95: Interval | null }[];
  least: number;
  most: number;
}

export type FlightEnd = 'arrived' | 'collided' | 'grounded' | 'gave_up' | 'time_up' | 'battery' | 'left_data' | 'stopped';

export interface Statistics {
  runs: number;
  ends: { end: FlightEnd; runs: number; share: number; share_interval_95: Interval }[];
  travel_time_s: Distribution | null;
  final_position_error_m: Distribution | null;
  worst_position_error_m: Distribution | null;
  clearance_m: Distribution | null;
  energy_j: Distribution | null;
}

export interface SimulationSummary extends Told {
  simulation_id: string;
  status: 'ok';
  plan_id: string;
  name: string;
  departure: string;
  planned_travel_time_s: number;
  seed: string;
  avoidance: boolean;
  tracks: number; // number of flights whose track is stored: the first ones
  runs: number;
  arrived: number;
  collisions: number;
  gave_up: number;
  median_detour_pct: number | null;
  statistics: Statistics;
  datasets: DatasetRef[];
  created?: string;
}

export interface Run {
  run: number;
  end: FlightEnd;
  travel_time_s: number;
  final_position_error_m: number;
  worst_position_error_m: number;
  clearance_m: number | null;
  energy_j: number;
  distance_m: number;
  why?: string | null; // why it did not arrive; missing in simulations of older versions
  could_be_saved?: boolean | null; // whether full knowledge could have prevented the contact; null if there was none
}

export interface Simulation extends SimulationSummary {
  flights: Run[];
}

export type FlightMode = 'mission' | 'path' | 'reactive' | 'given up';

export interface Track {
  time_s: number[]; // seconds since the departure
  lon: number[];
  lat: number[];
  depth_m: number[];
  believed_lon: number[];
  believed_lat: number[];
  sigma_m: number[];
  heading_deg: number[];
  at_surface: boolean[];
  mode: FlightMode[];
}

export interface FlightEvent {
  time: string;
  kind: 'departure' | 'dive' | 'inflection' | 'surfacing' | 'fix' | 'waypoint' | 'guidance' | 'contact' | 'end';
  text: string;
  lon: number;
  lat: number;
  depth_m: number;
}

/** A flight whose track is stored. */
export interface Flight {
  run: number;
  end: FlightEnd;
  end_reason: string;
  departure: string;
  finished: string;
  travel_time_s: number;
  distance_m: number;
  energy_j: number;
  track: Track;
  events: FlightEvent[];
  approaches: { to: string; distance_m: number; time: string; lon: number; lat: number; depth_m: number }[];
  sensors: {
    sonar: { time_s: number[]; returns: number[]; nearest_m: number[] };
    altimeter: { time_s: number[]; altitude_m: number[] };
  };
}
