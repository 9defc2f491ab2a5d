import { describe, expect, it } from 'vitest';
import { placesOfText } from '../../src/model/setup/pasted_places';

describe('a list of positions that is pasted', () => {
  it('gives start, via points and goal, without what lists write before them', () => {
    expect(placesOfText('Start: 69 12.0 N 53 12.0 W\r\n\r\n2) 69 11.0 N 52 50.0 W\nGoal: 69.15, -52.3\n')).toEqual({
      from: '69 12.0 N 53 12.0 W', via: '69 11.0 N 52 50.0 W', to: '69.15, -52.3',
    });
    expect(placesOfText('69.2 -53.2\n69.1 -52.3')).toEqual({ from: '69.2 -53.2', via: '', to: '69.1 -52.3' });
  });

  it('is any other text where a line is no position, or there is only one', () => {
    expect(placesOfText('69.2, -53.2')).toBeUndefined();
    expect(placesOfText('69.2, -53.2\nthen turn left')).toBeUndefined();
    expect(placesOfText('')).toBeUndefined();
  });
});
