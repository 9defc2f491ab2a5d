import { describe, expect, it } from 'vitest';
import { cautionsOf, dangersOf, warnedOf } from '../../src/model/dangers';

describe('what the server tells of', () => {
  const told = { dangers: ['Danger: a'], warnings: ['Danger: a', 'b', 'c'] };

  it('is sorted by rank, each sentence once', () => {
    expect(dangersOf(told)).toEqual(['a']);
    expect(cautionsOf(told)).toEqual(['b', 'c']);
    expect(warnedOf(told)).toBe(' 1 danger. 2 warnings.');
  });

  it('is all of one rank in answers that were stored before', () => {
    expect(dangersOf({ warnings: ['b'] })).toEqual([]);
    expect(warnedOf({ warnings: ['b'] })).toBe(' 1 warning.');
    expect(warnedOf({ warnings: [] })).toBe('');
  });
});
