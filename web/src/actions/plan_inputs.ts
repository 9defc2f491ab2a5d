import { effect, untracked } from '@preact/signals';
import { areaOf } from '../model/area';
import { planAreas } from '../model/plan/plan_areas';
import { routeOf, selectedId } from '../model/plan/plans';
import { rememberRequest, requestOf } from '../model/setup/requests';
import { startEdit } from '../model/plan/route_edit';
import { ask } from '../model/view';
import * as api from './client';
import type { Plan } from '../contract/types';

/**
 * Reads the inputs of a plan made elsewhere from the server, so that its route is evaluated by its own rules. If they
 * cannot be read, they are guessed, and the edit panel says so.
 */
export async function learnRequest(planId: string): Promise<void> {
  if (requestOf(planId)) return;
  try {
    rememberRequest(planId, await api.planInputs(planId));
  } catch {
    // Deleted meanwhile, or the server does not answer.
  }
}

/** Lets the map show the areas that the selected plan obeys. Call once. */
export function followPlanAreas(): void {
  effect(() => {
    const id = selectedId.value;
    planAreas.value = [];
    if (id !== undefined) void untracked(() => showAreas(id));
  });
}

async function showAreas(planId: string): Promise<void> {
  await learnRequest(planId);
  if (selectedId.peek() === planId) planAreas.value = (requestOf(planId)?.areas?.features ?? []).map(areaOf);
}

/** Opens a copy of a plan for changes and shows all of it, unless another plan was selected meanwhile. */
export async function editCopy(plan: Plan): Promise<void> {
  await learnRequest(plan.plan_id);
  if (selectedId.peek() !== plan.plan_id) return;
  startEdit(plan);
  ask({ do: 'fit', places: routeOf(plan) });
}
