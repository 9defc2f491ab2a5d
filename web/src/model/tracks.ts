import { computed, signal } from '@preact/signals';
import type { GliderTrackFeature, Position } from '../contract/data_types';
import { destination, inverse } from '../geo/geodesic';

/** The stored tracks of gliders. */
export const gliderTracks = signal<GliderTrackFeature[]>([]);

/** The track that the user chose. The clock then covers its period, however long ago that is. */
export const chosenTrackId = signal<GliderTrackFeature['id'] | undefined>(undefined);
export const chosenTrack = computed(() => gliderTracks.value.find(({ id }) => id === chosenTrackId.value));

/** The track under the pointer. */
export const hoveredTrack = signal<GliderTrackFeature | undefined>(undefined);

/** One place for each time of the track. The two places that are added where it crosses the antimeridian are left out. */
export function placesOf({ geometry }: GliderTrackFeature): Position[] {
  const lines = geometry.type === 'LineString' ? [geometry.coordinates] : geometry.coordinates;
  return lines.flatMap((line, i) => line.slice(i > 0 ? 1 : 0, i + 1 < lines.length ? -1 : undefined)).map(([lon = NaN, lat = NaN]) => [lon, lat]);
}

/** Where the glider was at a moment; undefined before its first fix and after its last. */
export function placeAt(track: GliderTrackFeature, at_ms: number): Position | undefined {
  const times_ms = track.properties.times.map((time) => Date.parse(time));
  const places = placesOf(track);
  const after = times_ms.findIndex((time) => time >= at_ms);
  const [to, to_ms] = [places[after], times_ms[after]];
  if (!to || to_ms === undefined) return undefined;
  if (to_ms === at_ms) return to;
  const [from, from_ms] = [places[after - 1], times_ms[after - 1]];
  if (!from || from_ms === undefined) return undefined;
  const leg = inverse(from, to);
  return leg.distance_m === 0 ? from : destination(from, leg.azimuth_deg, (leg.distance_m * (at_ms - from_ms)) / (to_ms - from_ms));
}
