import { expect, it } from 'vitest';
import { depth, none, wholeMetres } from '../../src/model/units';

it('rounds depths as the brief and the command line do, halves to the even number', () => {
  expect([1502.4, 1502.5, 1503.5, 1502.6, -0.5].map(wholeMetres)).toEqual(['1502', '1502', '1504', '1503', '0']);
  expect(depth(28.5)).toBe('28 m');
  expect(depth(null)).toBe(none);
});
