import { expect, it } from 'vitest';
import { depth, distance, energy, none, shownDistance_m, shownEnergy_j, wholeMetres } from '../../src/model/units';

it('rounds depths as the brief and the command line do, halves to the even number', () => {
  expect([1502.4, 1502.5, 1503.5, 1502.6, -0.5].map(wholeMetres)).toEqual(['1502', '1502', '1504', '1503', '0']);
  expect(depth(28.5)).toBe('28 m');
  expect(depth(null)).toBe(none);
});

it('states of a distance and an energy what its text states', () => {
  for (const [metres, greatest] of [[83.4, 900], [43_649, 48_600], [43_651, 48_600], [123_456, 200_000], [83.4, 48_600]] as const)
    expect(distance(shownDistance_m(metres, greatest), greatest)).toBe(distance(metres, greatest));
  expect(shownDistance_m(43_649, 48_600)).toBe(43_600);
  for (const [joules, greatest] of [[351_600, 352_000], [351_600, 2e6]] as const)
    expect(energy(shownEnergy_j(joules, greatest), greatest)).toBe(energy(joules, greatest));
});
