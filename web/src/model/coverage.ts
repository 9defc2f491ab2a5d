import { computed, signal } from '@preact/signals';
import type { Dataset } from '../contract/data_types';
import { datasets } from './datasets';

/** Datasets whose coverage is drawn on map and clock, by id. */
export const covered = signal<string[]>([]);

export const coveredDatasets = computed<Dataset[]>(() =>
  covered.value.flatMap((id) => datasets.value?.find((dataset) => dataset.id === id) ?? []),
);

export function toggleCoverage(id: string): void {
  covered.value = covered.value.includes(id) ? covered.value.filter((other) => other !== id) : [...covered.value, id];
}
