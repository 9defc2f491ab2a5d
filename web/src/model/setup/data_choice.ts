/**
 * A choice of several datasets in a field of the set-up: a word and the ids, in order of priority. Several currents are the members
 * of an ensemble. Of several depths the first has priority. Of icebergs, tides and zones all count.
 */
const word = 'several';

export const severalOf = (ids: string[]): string => [word, ...ids].join(' ');

/** The ids of a choice of several datasets; undefined where the choice is one id or a word such as "newest". */
export function severalIn(choice: string): string[] | undefined {
  const [first, ...ids] = choice.split(' ');
  return first === word ? ids : undefined;
}

/** The choice after a dataset is ticked or unticked. A newly ticked dataset comes last. */
export function ticked(choice: string, id: string, on: boolean): string {
  const others = (severalIn(choice) ?? []).filter((other) => other !== id);
  return severalOf(on ? [...others, id] : others);
}

/** The choice as the request states it. */
export const choiceInputs = (choice: string): string | string[] => {
  const ids = severalIn(choice);
  return ids?.length === 1 ? (ids[0] ?? choice) : (ids ?? choice);
};

/** The choice without the datasets that are no longer stored; undefined where none is left. */
export function withoutMissing(choice: string, isStored: (id: string) => boolean): string | undefined {
  const ids = severalIn(choice);
  if (!ids) return ['newest', 'none', 'all'].includes(choice) || isStored(choice) ? choice : undefined;
  const left = ids.filter(isStored);
  return left.length > 0 || ids.length === 0 ? severalOf(left) : undefined;
}
