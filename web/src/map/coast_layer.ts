import { effect } from '@preact/signals';
import type { CoastFeature, Position } from '../contract/data_types';
import { clipSouth } from '../geo/boxes';
import { mercatorNorthLimit_deg, polarSouthLimit_deg, projections, type ProjectionCode } from '../geo/projections';
import { coast } from '../model/field';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { palette } from '../theme/palette';
import { CanvasLayer, type Frame } from './canvas_layer';
import { toMap } from './projections';

/**
 * Land, drawn over the currents, so that no arrow is on land. Its outlines are one path in the projection, created once
 * for the loaded data, because passing tens of thousands of corners in each frame would slow down the clock.
 */
export function coastLayer(): CanvasLayer {
  let land = new Path2D();
  const layer = new CanvasLayer((frame) => paint(frame, land), 2);
  effect(() => {
    land = new Path2D();
    for (const feature of coast.value) addLand(land, feature, projection.value);
    layer.changed();
  });
  palette.subscribe(() => layer.changed());
  effect(() => layer.setVisible(visible.value.coast));
  return layer;
}

function addLand(path: Path2D, { geometry }: CoastFeature, code: ProjectionCode): void {
  const polygons = geometry.type === 'Polygon' ? [geometry.coordinates] : geometry.coordinates;
  for (const rings of polygons) {
    rings.forEach((ring, i) => {
      const drawn = toMap(code, clipped(ring, code));
      if (drawn.length > 3) addRing(path, drawn, i === 0);
    });
  }
}

/** Outer rings and lakes run in opposite senses, so that lakes stay open where polygons of land overlap. */
function addRing(path: Path2D, ring: number[][], isOuter: boolean): void {
  const turned = area2(ring) > 0 === isOuter ? ring : [...ring].reverse();
  turned.forEach(([x = NaN, y = NaN], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  path.closePath();
}

/** Twice the area of a closed ring, positive where it runs counter-clockwise. */
function area2(ring: number[][]): number {
  return ring.slice(1).reduce((sum, [x = NaN, y = NaN], i) => {
    const [fromX = NaN, fromY = NaN] = ring[i] ?? [];
    return sum + fromX * y - x * fromY;
  }, 0);
}

function clipped(ring: Position[], code: ProjectionCode): Position[] {
  if (projections[code].polar) return clipSouth(ring, polarSouthLimit_deg);
  return ring.map(([lon, lat]) => [lon, Math.min(lat, mercatorNorthLimit_deg)]);
}

function paint(frame: Frame, land: Path2D): void {
  const { context, resolution } = frame;
  const { land: fill, coast: line } = palette.peek();
  const [origin, right, up] = [frame.toPixel([0, 0]), frame.toPixel([resolution, 0]), frame.toPixel([0, resolution])];
  const scaled = (end: [number, number]): [number, number] => [(end[0] - origin[0]) / resolution, (end[1] - origin[1]) / resolution];
  context.save();
  context.transform(...scaled(right), ...scaled(up), ...origin);
  context.fillStyle = fill;
  context.fill(land);
  context.strokeStyle = line;
  context.lineWidth = resolution;
  context.lineJoin = 'round';
  context.stroke(land);
  context.restore();
}
