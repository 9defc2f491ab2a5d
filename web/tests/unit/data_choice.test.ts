import { describe, expect, it } from 'vitest';
import { choiceInputs, severalIn, severalOf, ticked, withoutMissing } from '../../src/model/setup/data_choice';

describe('a choice of data', () => {
  it('is a word, one dataset, or several in the order they were ticked', () => {
    expect(choiceInputs('newest')).toBe('newest');
    expect(choiceInputs('currents-1')).toBe('currents-1');
    expect(choiceInputs(severalOf(['currents-2']))).toBe('currents-2');
    expect(choiceInputs(ticked(ticked(severalOf([]), 'b', true), 'a', true))).toEqual(['b', 'a']);
    expect(severalIn(ticked(severalOf(['b', 'a']), 'b', false))).toEqual(['a']);
    expect(severalIn('none')).toBeUndefined();
  });

  it('lets go of what is no longer stored', () => {
    const isStored = (id: string): boolean => id === 'kept';
    expect(withoutMissing('newest', isStored)).toBe('newest');
    expect(withoutMissing('kept', isStored)).toBe('kept');
    expect(withoutMissing('gone', isStored)).toBeUndefined();
    expect(withoutMissing(severalOf(['gone', 'kept']), isStored)).toBe(severalOf(['kept']));
    expect(withoutMissing(severalOf(['gone']), isStored)).toBeUndefined();
  });
});
