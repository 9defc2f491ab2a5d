import { computed, signal } from '@preact/signals';
import type { Position } from '../contract/data_types';
import { openForm } from './hand_made';
import { tool } from './view';

/** The number of corners of the area that is being drawn. */
export const drawnCorners = signal(0);

/** An area with fewer corners has no inside. */
export const fewestCorners = 3;

/** An order to the drawing tool. Each new object is carried out once. */
export const drawingWish = signal<{ do: 'close' | 'removeLast' } | { do: 'corner'; place: Position } | undefined>(undefined);

export const isDrawing = computed(() => tool.value === 'area' || tool.value === 'zone');

/** Why planning is disabled now: the map shows an area that is not finished, which no plan would obey. */
export const whyNotPlanned = computed<string | undefined>(() => {
  if (isDrawing.value) return 'An area is being drawn. Close it with Enter or leave it with Esc, then plan.';
  if (openForm.value?.zone) return 'A zone is not stored yet. Store it or close its form under Data, then plan.';
  if (openForm.value?.berg) return 'An iceberg is not stored yet. Store it or close its form under Data, then plan.';
  return undefined;
});

/** Closes the area or removes its last corner, by key. Returns whether the key belonged to the drawing. */
export function drawByKey(key: string): boolean {
  if (!isDrawing.peek() || (key !== 'Enter' && key !== 'Backspace')) return false;
  drawingWish.value = { do: key === 'Enter' ? 'close' : 'removeLast' };
  return true;
}
