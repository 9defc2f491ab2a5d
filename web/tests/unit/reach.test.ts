import { describe, expect, it } from 'vitest';
import { hoursIn } from '../../src/model/reach';

describe('hours', () => {
  it('are read as people list them, each once and in order', () => {
    expect(hoursIn('24, 6;12  6')).toEqual([6, 12, 24]);
    expect(hoursIn('1.5')).toEqual([1.5]);
  });

  it('are refused where one is no length of time', () => {
    for (const text of ['', 'six', '6, -1', '0']) expect(hoursIn(text)).toBeUndefined();
  });
});
