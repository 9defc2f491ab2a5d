import { describe, expect, it } from 'vitest';
import { labelsWithRoom, type Label } from '../../src/map/label_room';

const row = (places: number[]): Label[] => places.map((x, i) => ({ at: [x, 0], text: String(i) }));

describe('names of places on the map', () => {
  it('all show where they lie apart, and fewer the smaller the map is drawn', () => {
    const labels = row([0, 1000, 2000, 3000, 4000]);
    const withRoom = labelsWithRoom(labels);
    const shown = [10, 60, 130, 10_000].map((resolution) => [...withRoom(resolution)].map(({ text }) => text).join(' '));
    expect(shown).toEqual(['0 1 2 3 4', '0 2 4', '0 3', '0']);
  });

  it('give way to those before them in the list', () => {
    const [first, second] = [{ at: [50, 0], text: '7' }, { at: [0, 0], text: 'S' }];
    expect([...labelsWithRoom([first, second])(10)]).toEqual([first]);
  });

  it('need more room the longer they are', () => {
    const long: Label[] = [{ at: [0, 0], text: '100' }, { at: [0, 200], text: '1' }];
    expect(labelsWithRoom(long)(10).size).toBe(1);
    expect(labelsWithRoom(row([0, 200]))(10).size).toBe(2);
  });
});
