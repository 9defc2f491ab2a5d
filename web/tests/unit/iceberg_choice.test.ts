import { afterEach, describe, expect, it } from 'vitest';
import { emptyDraft, fill } from '../../src/model/draft';
import { choiceInWords, icebergChoice } from '../../src/model/iceberg_choice';

afterEach(() => fill(emptyDraft));

describe('the icebergs on the map', () => {
  it('are those of all datasets unless the set-up says otherwise', () => {
    expect(icebergChoice.value).toEqual({ datasets: undefined, max_sighting_age_days: undefined });
    expect(choiceInWords.value).toBeUndefined();
  });

  it('are those of the datasets and of the age that the set-up asks for, and that is said', () => {
    fill({ icebergs: 'several b a', max_sighting_age_days: '1,5' });
    expect(icebergChoice.value).toEqual({ datasets: ['b', 'a'], max_sighting_age_days: 1.5 });
    expect(choiceInWords.value).toBe('of the 2 datasets chosen, seen within 1.5 d');
    fill({ icebergs: 'none' });
    expect(icebergChoice.value).toBeUndefined();
    expect(choiceInWords.value).toBe('left out by the set-up');
  });
});
