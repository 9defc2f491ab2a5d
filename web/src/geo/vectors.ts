import { northAngle, type ProjectionCode } from './projections';
import type { Position } from '../contract/data_types';

/** Turns a velocity given as true east and north into the projection's x and y, keeping its strength. */
export function rotateToView(code: ProjectionCode, place: Position, east: number, north: number): [x: number, y: number] {
  return rotateByNorth(northAngle(code, place), east, north);
}

/** As `rotateToView`, with the direction of north already known (radians counter-clockwise from x). */
export function rotateByNorth(north_rad: number, east: number, north: number): [x: number, y: number] {
  const cos = Math.cos(north_rad);
  const sin = Math.sin(north_rad);
  return [north * cos + east * sin, north * sin - east * cos];
}

/** Direction a vector points towards, degrees clockwise from true north, 0 to 360. */
export function directionTowards_deg(east: number, north: number): number {
  const angle = (Math.atan2(east, north) * 180) / Math.PI;
  return (angle + 360) % 360;
}
