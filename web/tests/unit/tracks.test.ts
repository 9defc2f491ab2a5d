import { describe, expect, it } from 'vitest';
import type { GliderTrackFeature } from '../../src/contract/data_types';
import { placeAt, placesOf } from '../../src/model/tracks';

const track = (geometry: GliderTrackFeature['geometry'], times: string[]): GliderTrackFeature => ({
  type: 'Feature', id: 1, geometry,
  properties: { glider: 'g', start: times[0] ?? '', end: times.at(-1) ?? '', deepest_m: null, mean_east_m_s: null, mean_north_m_s: null, current_frame: null, times, currents: [], dataset_id: 'd' },
});
const hours = ['2026-11-20T00:00:00Z', '2026-11-20T01:00:00Z', '2026-11-20T02:00:00Z'];

describe('the track of a glider', () => {
  it('says where it was between two fixes, and nothing before and after', () => {
    const one = track({ type: 'LineString', coordinates: [[-52, 69, -10], [-52, 69.1, 0], [-52, 69.1, 0]] }, hours);
    expect(placeAt(one, Date.parse('2026-11-20T00:30:00Z'))?.[1]).toBeCloseTo(69.05, 4);
    expect(placeAt(one, Date.parse('2026-11-20T01:30:00Z'))).toEqual([-52, 69.1]);
    expect(placeAt(one, Date.parse('2026-11-19T23:59:00Z'))).toBeUndefined();
    expect(placeAt(one, Date.parse('2026-11-20T02:01:00Z'))).toBeUndefined();
  });

  it('leaves out the places on the edge of the map where it crosses the antimeridian', () => {
    const one = track({ type: 'MultiLineString', coordinates: [[[179, 70], [180, 70]], [[-180, 70], [-179, 70], [-178, 70]]] }, hours);
    expect(placesOf(one)).toEqual([[179, 70], [-179, 70], [-178, 70]]);
  });
});
