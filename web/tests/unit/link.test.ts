import { describe, expect, it } from 'vitest';
import { readLink, written, type Link } from '../../src/model/link';

describe('the link to a view', () => {
  it('is read back as it was written', () => {
    const link: Link = {
      projection: 'EPSG:3995', centre: [-52.1234, 69.4321], metresPerPixel: 123.4, time_ms: Date.parse('2026-11-22T06:00:00Z'),
      hidden: ['coast'], plans: ['p1', 'p2'], selected: 'p2',
    };
    expect(readLink(`#${written(link)}`)).toEqual(link);
  });

  it('leaves out what cannot be read', () => {
    expect(readLink('#crs=1234&at=95,0,10&time=soon&plans=<script>&plan=')).toEqual({ plans: [] });
    expect(readLink('')).toEqual({});
  });
});
