import { computed } from '@preact/signals';
import { severalIn } from './data_choice';
import { draft, numberIn } from './draft';
import { parseTime } from './time';

/** Which icebergs a plan is to obey: of all datasets unless some are named, and of sightings so many days old. */
export interface IcebergChoice {
  datasets: string[] | undefined;
  max_sighting_age_days: number | undefined; // the server's own where nobody says
}

/** What the set-up asks for, which the map shows too; undefined: no icebergs. */
export const icebergChoice = computed<IcebergChoice | undefined>(() => {
  const wish = draft.value.icebergs;
  if (wish === 'none') return undefined;
  const named = wish === 'newest' ? undefined : (severalIn(wish) ?? [wish]);
  if (named?.length === 0) return undefined; // a choice of several, none of them ticked yet
  const days = numberIn(draft.value.max_sighting_age_days);
  return { datasets: named, max_sighting_age_days: days !== undefined && days >= 0 && days <= 30 ? days : undefined };
});

/** The moment after which the set-up lets no sighting count; undefined: that of the departure, for the map the clock's. */
export const knownAt_ms = computed(() => parseTime(draft.value.icebergs_as_of));

/** In words, what the map shows other than every recent sighting; undefined: just that. */
export const choiceInWords = computed<string | undefined>(() => {
  const choice = icebergChoice.value;
  if (!choice) return 'left out by the set-up';
  const words = [
    choice.datasets && (choice.datasets.length === 1 ? 'of the dataset chosen' : `of the ${choice.datasets.length} datasets chosen`),
    choice.max_sighting_age_days !== undefined && `seen within ${choice.max_sighting_age_days} d`,
    knownAt_ms.value !== undefined && 'as known at the time set',
  ].filter((part) => typeof part === 'string');
  return words.length > 0 ? words.join(', ') : undefined;
});
