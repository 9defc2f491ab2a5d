import { describe, expect, it } from 'vitest';
import type { Flight } from '../../src/contract/simulation_types';
import type { Position } from '../../src/contract/data_types';
import { destination } from '../../src/geo/geodesic';
import { crossTrackOf, momentOf, returnsOf, sonarAt, stretchesOf } from '../../src/model/plan/flight';

const start: Position = [-52, 69];
const north_m = (metres: number): Position => destination(start, 0, metres);
const departure_ms = Date.parse('2026-11-20T06:00:00Z');

/** Ten minutes northwards at 1 m/s, a row each minute. */
function straightFlight(): Flight {
  const minutes = Array.from({ length: 11 }, (_, i) => i);
  const places = minutes.map((minute) => north_m(60 * minute));
  return {
    run: 0, end: 'arrived', end_reason: '', departure: '2026-11-20T06:00:00Z', finished: '2026-11-20T06:10:00Z', travel_time_s: 600,
    distance_m: 600, energy_j: 1,
    track: {
      time_s: minutes.map((minute) => 60 * minute), lon: places.map(([lon]) => lon), lat: places.map(([, lat]) => lat),
      depth_m: minutes.map((minute) => 10 * minute), believed_lon: places.map(([lon]) => lon), believed_lat: places.map(([, lat]) => lat),
      sigma_m: minutes, heading_deg: minutes.map(() => 0), at_surface: minutes.map((minute) => minute === 0), mode: minutes.map(() => 'mission'),
    },
    events: [], approaches: [],
    sensors: { sonar: { time_s: [100, 200], returns: [1, 3], nearest_m: [80, 50] }, altimeter: { time_s: [], altitude_m: [] } },
  };
}

describe('a flight at a moment', () => {
  it('lies between the rows of its track, and nowhere before and after it', () => {
    const now = momentOf(straightFlight(), departure_ms + 90_000);
    expect(now?.depth_m).toBeCloseTo(15, 6);
    expect(now?.place[1]).toBeCloseTo(north_m(90)[1], 8);
    expect(momentOf(straightFlight(), departure_ms - 1)).toBeUndefined();
    expect(momentOf(straightFlight(), departure_ms + 600_000)?.depth_m).toBe(100);
    expect(momentOf(straightFlight(), departure_ms + 600_001)).toBeUndefined();
  });

  it('knows the last ping for a while only', () => {
    expect(sonarAt(straightFlight(), departure_ms + 99_000, 60)).toBeUndefined();
    expect(sonarAt(straightFlight(), departure_ms + 150_000, 60)?.nearest_m).toBe(80);
    expect(sonarAt(straightFlight(), departure_ms + 200_000, 60)).toEqual({ nearest_m: 50, returns: 3 });
    expect(sonarAt(straightFlight(), departure_ms + 300_000, 60)).toBeUndefined();
  });
});

it('a sonar tells echoes from lone returns', () => {
  expect(returnsOf(straightFlight())).toEqual({ lone: [80, null], echoes: [null, 50] });
});

describe('the cross-track error', () => {
  const corner = north_m(1000);
  const crossTrack = crossTrackOf([start, corner, destination(corner, 90, 1000)]);

  it('is positive to the right of the way and negative to its left', () => {
    expect(crossTrack(destination(north_m(500), 90, 70))).toBeCloseTo(70, 2);
    expect(crossTrack(destination(north_m(500), 270, 70))).toBeCloseTo(-70, 2);
  });

  it('is that of the nearest leg, and the distance to its end beyond the ends', () => {
    expect(Math.abs(crossTrack(destination(start, 180, 40)))).toBeCloseTo(40, 2);
    expect(crossTrack(destination(destination(corner, 90, 600), 0, 30))).toBeCloseTo(-30, 1);
    expect(crossTrack(start)).toBeCloseTo(0, 6);
  });
});

it('stretches of one mode follow each other without a gap', () => {
  const stretches = stretchesOf(['mission', 'mission', 'path', 'reactive', 'reactive', 'mission']);
  expect(stretches.map(({ mode, first, last }) => `${mode} ${first}-${last}`)).toEqual(['mission 0-1', 'path 2-2', 'reactive 3-4', 'mission 5-5']);
  expect(stretchesOf([])).toEqual([]);
});
