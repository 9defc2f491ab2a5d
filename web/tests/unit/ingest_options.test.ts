import { describe, expect, it } from 'vitest';
import { askedFor, emptyForm, inWords, optionsOf } from '../../src/model/ingest_options';

const sign = 'the sign of "elevation" is unknown; land and sea must not be mixed up; say --positive up (elevations) or --positive down (depths)';

describe('what a refused file leaves open', () => {
  it('is asked by the option that the refusal names, once each', () => {
    expect(askedFor([sign, 'no reference system; give it with --crs, for example --crs EPSG:4326'])).toEqual(['positive', 'crs']);
    expect(askedFor(['a rule is missing; give --zone-kind for all that state none'])).toEqual(['zone_kind']);
    expect(askedFor(['row 4: longitude 999 is no longitude', 'an unknown --option'])).toEqual([]);
  });

  it('is worded as the form calls its fields', () => {
    expect(inWords(sign)).toContain('say “Positive” up (elevations) or “Positive” down (depths)');
    expect(inWords('ingest the file again with --kind ice')).toBe('ingest the file again with “Kind: sea ice”');
    expect(inWords('an unknown --option')).toBe('an unknown --option');
  });

  it('is sent only as far as something was stated', () => {
    expect(optionsOf(emptyForm)).toEqual({ options: {} });
    expect(optionsOf({ ...emptyForm, positive: 'down', crs: ' EPSG:3413 ' })).toEqual({ options: { positive: 'down', crs: 'EPSG:3413' } });
    expect(optionsOf({ ...emptyForm, at: '69.5, -51' })).toEqual({ options: { at: [-51, 69.5] } });
    expect(optionsOf({ ...emptyForm, at: 'somewhere' })).toHaveProperty('fault');
    expect(optionsOf({ ...emptyForm, missing: ' -99.99' })).toEqual({ options: { missing: -99.99 } });
    expect(optionsOf({ ...emptyForm, missing: 'none' })).toHaveProperty('fault');
  });
});
