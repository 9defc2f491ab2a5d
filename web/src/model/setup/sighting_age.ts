import { day_ms } from '../time';

/** Sightings older than this at departure do not count, by whole days, unless the request says otherwise. */
export const sighting_days = 3;

/**
 * The earliest sighting of an iceberg that counts for a vehicle that leaves at that moment. The rule is the server's
 * (ocean::oldest_that_counts): by whole UTC days, and at the departure, however long the vehicle is under way.
 */
export const oldestThatCounts_ms = (departure_ms: number, days: number): number => Math.floor(departure_ms / day_ms - days) * day_ms;
