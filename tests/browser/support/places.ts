import type { APIRequestContext } from '@playwright/test';
import type { LonLat } from './page';

interface Dataset {
  kind: string;
  bbox: [number, number, number, number];
  times?: string[];
  time_start: string | null;
}

interface Probe {
  land: boolean | null;
  depth_m: number | null;
  currents: { u_m_s: number | null };
  icebergs_within: { distance_m: number }[];
  ice_concentration: number | null;
}

export interface Places {
  start: LonLat;
  goal: LonLat;
  land: LonLat;
}

let found: Promise<Places> | undefined;

/** The places that `searchPlaces` finds. Every server starts from the same data, so one search serves all tests of a worker. */
export const findPlaces = (request: APIRequestContext): Promise<Places> => (found ??= searchPlaces(request));

/**
 * Places that suit whatever is in the store: two at sea, deep, away from icebergs and sea ice and about `apart_deg` of latitude from
 * each other, and the land nearest to them. Found by asking the server along a lattice over the area of the currents.
 */
async function searchPlaces(request: APIRequestContext): Promise<Places> {
  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: Dataset[] };
  const currents = datasets.find(({ kind }) => kind === 'currents');
  if (!currents) throw new Error('The store has no currents.');
  const time = currents.times?.[Math.floor(currents.times.length / 3)] ?? currents.time_start ?? '';
  const [west, south, east, north] = currents.bbox;
  const probeAt = async ([lon, lat]: LonLat, when: string): Promise<Probe | undefined> => {
    const response = await request.get('/probe', { params: { lon: lon.toFixed(6), lat: lat.toFixed(6), time: when } });
    return response.ok() ? ((await response.json()) as Probe) : undefined;
  };
  // Sea ice drifts, and journeys depart when they like.
  const isOpen = async (place: LonLat): Promise<boolean> => {
    for (const when of [currents.times?.[0] ?? time, time, currents.times?.at(-1) ?? time]) {
      if (((await probeAt(place, when))?.ice_concentration ?? 0) > 0) return false;
    }
    return true;
  };

  const sea: LonLat[] = [];
  const land: LonLat[] = [];
  const steps = 12;
  for (let j = 2; j <= steps - 2; ++j) {
    for (let i = 1; i < steps; ++i) {
      const place: LonLat = [west + ((east - west) * i) / steps, south + ((north - south) * j) / steps];
      const probe = await probeAt(place, time);
      if (!probe) continue;
      if (probe.land === true || (probe.depth_m !== null && probe.depth_m < 0)) land.push(place);
      const clear = probe.icebergs_within.every(({ distance_m }) => distance_m > 4000);
      if (probe.land !== true && (probe.depth_m ?? 0) > 150 && probe.currents.u_m_s !== null && clear && (await isOpen(place))) sea.push(place);
    }
  }
  const pair = nearestPair(sea);
  const ashore = pair && nearestTo(pair[1], land);
  if (!pair || !ashore) throw new Error(`Only ${sea.length} places at sea and ${land.length} on land were found.`);
  return { start: pair[0], goal: pair[1], land: ashore };
}

/** Two neighbours near the middle of the sea found: their leg is short and has water on all sides. */
function nearestPair(sea: LonLat[]): [LonLat, LonLat] | undefined {
  const middle = sea[Math.floor(sea.length / 2)];
  if (!middle) return undefined;
  const other = nearestTo(middle, sea.filter((place) => place !== middle));
  return other && [middle, other];
}

function nearestTo(here: LonLat, places: LonLat[]): LonLat | undefined {
  const away = (place: LonLat): number => Math.hypot((place[0] - here[0]) * 0.4, place[1] - here[1]);
  return [...places].sort((a, b) => away(a) - away(b))[0];
}
