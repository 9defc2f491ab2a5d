import { computed, signal } from '@preact/signals';
import type { Flight, Simulation, SimulationSummary } from '../../contract/simulation_types';
import type { JobStatus } from '../../contract/types';
import { selectedId } from './plans';

/** Stored simulations by plan id, newest first; absent until the server has answered. */
export const stored = signal<Record<string, SimulationSummary[]>>({});

/** The form of a simulation: texts until they are sent. */
export interface FlightForm {
  runs: string;
  current_error_m_s: string;
  seed: string;
  avoidance: boolean;
}

export const flightForm = signal<FlightForm>({ runs: '1', current_error_m_s: '0.05', seed: '1', avoidance: true });

/** The simulation under way, of one plan at a time. */
export const flying = signal<{ planId: string; status: JobStatus | undefined } | undefined>(undefined);
export const flyingFault = signal<string | undefined>(undefined);

export const opened = signal<Simulation | undefined>(undefined);
export const playedFlight = signal<Flight | undefined>(undefined);

/** The flight in view: one of the selected plan. */
export const shownFlight = computed(() => (opened.value?.plan_id === selectedId.value ? playedFlight.value : undefined));

export function closeSimulation(): void {
  opened.value = undefined;
  playedFlight.value = undefined;
}
