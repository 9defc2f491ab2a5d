import { beforeEach, describe, expect, it } from 'vitest';
import { edit } from '../../src/model/draft';
import { keepOut_m } from '../../src/model/icebergs';

describe('the distance kept from a berg', () => {
  beforeEach(() => edit({ margin_m: '500', max_inflation_m: '' }));

  it('is hull, margin and the error of its position, up to a bound', () => {
    expect(keepOut_m(200, 1200)).toBe(100 + 500 + 1200);
    expect(keepOut_m(200, 90_000)).toBe(100 + 500 + 5000);
    edit({ margin_m: '50', max_inflation_m: '800' });
    expect(keepOut_m(200, 1200)).toBe(100 + 50 + 800);
  });

  it('takes the usual values where the set-up says nothing that can be read', () => {
    edit({ margin_m: 'far', max_inflation_m: '-3' });
    expect(keepOut_m(0, 90_000)).toBe(500 + 5000);
  });
});
