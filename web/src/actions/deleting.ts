import type { Plan } from '../contract/types';
import { bringBack, forget, plans, selectedId, shown, titleOf } from '../model/plan/plans';
import { tell } from '../model/screen';
import { forgetChanges, remember } from '../model/undo';
import * as api from './client';

/** Time for which a deleted plan stays in the store, so that undo can bring it back. */
const grace_ms = 60_000;

/** Deleted plans that are still in the store. */
const leaving = new Map<string, { plan: Plan; timer: ReturnType<typeof setTimeout> }>();

/** The stored plans without those that were deleted in this page. */
export const withoutDeleted = (stored: Plan[]): Plan[] => stored.filter(({ plan_id }) => !leaving.has(plan_id));

const changesOf = (id: string): string => `plan ${id}`;

/** Removes a plan from the page at once, and from the store when undo is no longer possible. */
export function deletePlan(plan: Plan): void {
  const id = plan.plan_id;
  const [index, wasShown, wasSelected] = [plans.peek().indexOf(plan), shown.peek().includes(id), selectedId.peek() === id];
  const take = (): void => {
    leaving.set(id, { plan, timer: setTimeout(() => void carryOut(plan), grace_ms) });
    forget(id);
  };
  const back = (): void => {
    clearTimeout(leaving.get(id)?.timer);
    leaving.delete(id);
    bringBack(plan, index, wasShown, wasSelected);
  };
  take();
  remember({ title: `deleting ${titleOf(plan)}`, of: changesOf(id), back, again: take });
  tell(`${titleOf(plan)} was deleted. For a minute, undo (Ctrl+Z) brings it back.`);
}

async function carryOut(plan: Plan): Promise<void> {
  const { plan_id: id } = plan;
  forgetChanges(changesOf(id));
  try {
    await api.deletePlan(id);
    leaving.delete(id);
  } catch (error) {
    leaving.delete(id);
    bringBack(plan, 0, false, false);
    tell(`${titleOf(plan)} could not be deleted: ${api.wordsOf(error)}`);
  }
}

/** Deletes at once when the page is left, because undo is then no longer possible. Call once. */
export function deleteOnLeaving(): void {
  window.addEventListener('pagehide', () => {
    for (const { plan, timer } of leaving.values()) {
      clearTimeout(timer);
      void carryOut(plan);
    }
  });
}
