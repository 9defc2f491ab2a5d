import type { SimulationSummary } from '../contract/simulation_types';
import type { Plan } from '../contract/types';
import { bringBack, forget, plans, selectedId, shown, titleOf } from '../model/plan/plans';
import { closeSimulation, opened, playedFlight, stored } from '../model/plan/simulations';
import { tell } from '../model/screen';
import { forgetChanges, remember } from '../model/undo';
import * as api from './client';

/** Time for which something deleted stays in the store, so that undo can bring it back. */
const grace_ms = 60_000;

/** Something in the store that a person deletes. */
interface Deletion {
  id: string;
  title: string; // at the beginning of a sentence: “Plan 2”, “The simulation”
  titleInside: string; // inside a sentence: “Plan 2”, “the simulation”
  take: () => void; // from the page
  back: () => void; // to the page
  remove: () => Promise<void>; // from the store
}

/** What was deleted and is still in the store. */
const leaving = new Map<string, { deletion: Deletion; timer: ReturnType<typeof setTimeout> }>();

/** The stored plans without those that were deleted in this page. */
export const withoutDeleted = (all: Plan[]): Plan[] => all.filter(({ plan_id }) => !leaving.has(plan_id));

/** The stored simulations without those that were deleted in this page. */
export const withoutDeletedSimulations = (all: SimulationSummary[]): SimulationSummary[] => all.filter(({ simulation_id }) => !leaving.has(simulation_id));

/** Takes something off the page at once, and from the store when undo is no longer possible. */
function deleteLater(deletion: Deletion): void {
  const { id, title, titleInside } = deletion;
  const take = (): void => {
    leaving.set(id, { deletion, timer: setTimeout(() => void carryOut(deletion), grace_ms) });
    deletion.take();
  };
  const back = (): void => {
    clearTimeout(leaving.get(id)?.timer);
    leaving.delete(id);
    deletion.back();
  };
  take();
  remember({ title: `deleting ${titleInside}`, of: id, back, again: take });
  tell(`${title} was deleted. For a minute, undo (Ctrl+Z) brings it back.`);
}

export function deletePlan(plan: Plan): void {
  const id = plan.plan_id;
  const [index, wasShown, wasSelected] = [plans.peek().indexOf(plan), shown.peek().includes(id), selectedId.peek() === id];
  deleteLater({
    id,
    title: titleOf(plan),
    titleInside: titleOf(plan),
    take: () => forget(id),
    back: () => bringBack(plan, index, wasShown, wasSelected),
    remove: () => api.deletePlan(id),
  });
}

export function deleteSimulation(simulation: SimulationSummary): void {
  const { plan_id, simulation_id: id } = simulation;
  const listed = (): SimulationSummary[] => stored.peek()[plan_id] ?? [];
  const index = listed().indexOf(simulation);
  const open = opened.peek()?.simulation_id === id ? { simulation: opened.peek(), flight: playedFlight.peek() } : undefined;
  deleteLater({
    id,
    title: 'The simulation',
    titleInside: 'the simulation',
    take: () => {
      stored.value = { ...stored.peek(), [plan_id]: listed().filter(({ simulation_id }) => simulation_id !== id) };
      if (opened.peek()?.simulation_id === id) closeSimulation();
    },
    back: () => {
      stored.value = { ...stored.peek(), [plan_id]: listed().toSpliced(index, 0, simulation) };
      if (!open) return;
      opened.value = open.simulation;
      playedFlight.value = open.flight;
    },
    remove: () => api.deleteSimulation(id),
  });
}

const isGone = (error: unknown): boolean => error instanceof api.ApiError && error.problem.status === 404;

async function carryOut({ id, title, back, remove }: Deletion): Promise<void> {
  forgetChanges(id);
  try {
    await remove();
    leaving.delete(id);
  } catch (error) {
    leaving.delete(id);
    if (isGone(error)) return;
    back();
    tell(`${title} could not be deleted: ${api.wordsOf(error)}`);
  }
}

/** Deletes at once when the page is left, because undo is then no longer possible. Call once. */
export function deleteOnLeaving(): void {
  window.addEventListener('pagehide', () => {
    for (const { deletion, timer } of leaving.values()) {
      clearTimeout(timer);
      void carryOut(deletion);
    }
  });
}
