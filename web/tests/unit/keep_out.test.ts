import { beforeEach, describe, expect, it } from 'vitest';
import type { IcebergProperties } from '../../src/contract/data_types';
import { keepOutRadii_m, keepOut_m } from '../../src/model/ice/icebergs';
import { emptyDraft, fill } from '../../src/model/setup/draft';

const berg = (position_uncertainty_m: number | null): IcebergProperties => ({ safe_length_m: 400, position_uncertainty_m }) as IcebergProperties;

describe('what plans keep clear of an iceberg', () => {
  beforeEach(() => fill(emptyDraft));

  it('is hull and margin, and the position error as far as the set-up lets it count', () => {
    expect(keepOutRadii_m(berg(null))).toEqual({ kept_m: 700, uncertain_m: 700 });
    expect(keepOutRadii_m(berg(1200))).toEqual({ kept_m: 700, uncertain_m: 1900 });
    expect(keepOutRadii_m(berg(25_500))).toEqual({ kept_m: 700, uncertain_m: 5700 });
    expect(keepOut_m(400, 25_500)).toBe(5700);
    fill({ max_inflation_m: '2000', margin_m: '1000' });
    expect(keepOutRadii_m(berg(25_500))).toEqual({ kept_m: 1200, uncertain_m: 3200 });
  });
});
