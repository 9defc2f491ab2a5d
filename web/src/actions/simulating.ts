import { numberIn } from '../model/setup/draft';
import { endedSo, endTitles } from '../model/plan/flight';
import { flightForm, flying, flyingFault, opened, playedFlight, stored } from '../model/plan/simulations';
import { announce } from '../model/screen';
import * as api from './client';
import { withoutDeletedSimulations } from './deleting';
import { follow } from './following';
import type { SimulateInputs } from '../contract/simulation_types';
import type { Plan } from '../contract/types';

let cancelled: AbortController | undefined;

/** Simulates a plan with the form's settings and opens the result. */
export async function fly(plan: Plan): Promise<void> {
  if (flying.value) return;
  const inputs = inputsFor(plan);
  if (typeof inputs === 'string') {
    flyingFault.value = inputs;
    return;
  }
  flyingFault.value = undefined;
  flying.value = { planId: plan.plan_id, status: undefined };
  const { signal } = (cancelled = new AbortController());
  try {
    const job = await follow(await api.submitSimulation(inputs), signal, (status) => {
      flying.value = { planId: plan.plan_id, status };
    });
    if (job.status === 'failed') throw new Error(job.message || 'The server gave no reason.');
    if (job.status === 'dismissed') {
      announce('The simulation was cancelled.');
      return;
    }
    const { simulation } = await api.simulationResults(job.jobID);
    if (simulation.status === 'cancelled') return;
    await listSimulations(plan.plan_id);
    await openSimulation(simulation.simulation_id);
    announce(`Flown: ${simulation.arrived} of ${simulation.runs} arrived, ${endedSo(simulation, 'collided')} collided, ${endedSo(simulation, 'grounded')} grounded.`);
  } catch (error) {
    if (!signal.aborted) flyingFault.value = api.wordsOf(error);
  } finally {
    flying.value = undefined;
  }
}

export const cancelFlight = (): void => cancelled?.abort();

/** The inputs, or why the form has none. */
function inputsFor({ plan_id }: Plan): SimulateInputs | string {
  const { runs, current_error_m_s, seed, avoidance } = flightForm.value;
  const [count, error, number] = [numberIn(runs), numberIn(current_error_m_s), numberIn(seed)];
  if (count === undefined || error === undefined || number === undefined) return 'Flights, current error and seed must be numbers.';
  return { plan_id, runs: count, seed: number, avoidance, ...(error > 0 ? { current_error: { rms_m_s: error } } : {}) };
}

export async function listSimulations(planId: string): Promise<void> {
  try {
    const { simulations } = await api.simulations(planId);
    stored.value = { ...stored.value, [planId]: withoutDeletedSimulations(simulations) };
  } catch (error) {
    flyingFault.value = api.wordsOf(error);
  }
}

/** Opens a simulation and its first flight, if that is stored. */
export async function openSimulation(id: string): Promise<void> {
  try {
    const simulation = await api.simulation(id);
    opened.value = simulation;
    playedFlight.value = undefined;
    if (simulation.tracks > 0) await playFlight(id, 0);
  } catch (error) {
    flyingFault.value = api.wordsOf(error);
  }
}

export async function playFlight(id: string, run: number): Promise<void> {
  try {
    const flight = await api.flight(id, run);
    if (opened.value?.simulation_id !== id) return;
    playedFlight.value = flight;
    announce(`Flight ${run + 1}: ${endTitles[flight.end]}. ${flight.end_reason}`);
  } catch (error) {
    flyingFault.value = api.wordsOf(error);
  }
}
