import { expect, it } from 'vitest';
import { rangeOf } from '../../src/ui/charts/plot';

it('leaves a little room beside the figures', () => {
  expect(rangeOf(10, 20, false)).toEqual([9.4, 20.6]);
  expect(rangeOf(10, 20, true)).toEqual([0, 21.2]);
  expect(rangeOf(null, null, false)).toEqual([0, 1]);
});

it('gives figures that hardly differ an axis of two per cent', () => {
  const [low, high] = rangeOf(12.41, 12.41, false);
  expect(high - low).toBeCloseTo(0.02 * 12.41);
  expect((low + high) / 2).toBeCloseTo(12.41);
  const [deep, shallow] = rangeOf(-200, -200, false);
  expect(shallow - deep).toBeCloseTo(4);
});
