import { computed, signal } from '@preact/signals';
import { isSameArea, type Area } from '../area';
import { draft } from '../setup/draft';

/** The areas that the selected plan obeys by its own request; none while they are not known. */
export const planAreas = signal<Area[]>([]);

/** Those of them that the set-up does not have as well. */
export const areasOfPlanAlone = computed(() => planAreas.value.filter((area) => !draft.value.areas.some((other) => isSameArea(area, other))));
