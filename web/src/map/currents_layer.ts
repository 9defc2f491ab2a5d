import { effect } from '@preact/signals';
import { samplePair } from '../geo/grid';
import { northAngle, unproject, type ProjectionCode } from '../geo/projections';
import { rotateByNorth } from '../geo/vectors';
import { currents } from '../model/field';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import type { Position } from '../contract/data_types';
import { currentLimits_m_s, palette } from '../theme/palette';
import { CanvasLayer, type Frame } from './canvas_layer';

/** Least distance between arrows on the screen. */
const spacing_px = 34;

interface Stand {
  coordinate: Position; // in the projection
  place: Position;
  north_rad: number; // direction of true north, counter-clockwise from the projection's x
}

/**
 * Arrows of the current at the clock's time, rotated from true east and north to the view at each place. They are on a
 * lattice of the projection, so that they do not move when the map is moved.
 */
export function currentsLayer(): CanvasLayer {
  const stands = new Stands();
  const layer = new CanvasLayer((frame) => paint(frame, stands.within(frame, projection.peek())), 1);
  effect(() => {
    layer.setVisible(visible.value.currents && currents.value !== undefined);
  });
  for (const cause of [currents, palette, projection]) cause.subscribe(() => layer.changed());
  return layer;
}

/** The lattice points in view; their positions and directions are cached while in view. */
class Stands {
  private known = new Map<string, Stand>();
  private shown: { window: string; stands: Stand[] } = { window: '', stands: [] };

  within(frame: Frame, code: ProjectionCode): Stand[] {
    const step = 2 ** (Math.ceil(2 * Math.log2(spacing_px * frame.resolution)) / 2);
    const corners = [[0, 0], [frame.width, 0], [0, frame.height], [frame.width, frame.height]] as const;
    const coordinates = corners.map((corner) => frame.toCoordinate(corner));
    const bounds = (axis: 0 | 1): [number, number] => {
      const values = coordinates.map((coordinate) => coordinate[axis] / step);
      return [Math.floor(Math.min(...values)), Math.ceil(Math.max(...values))];
    };
    const [west, east] = bounds(0);
    const [south, north] = bounds(1);

    const window = [code, step, west, east, south, north].join();
    if (this.shown.window === window) return this.shown.stands;

    const kept = new Map<string, Stand>();
    for (let j = south; j <= north; ++j) {
      for (let i = west; i <= east; ++i) {
        const key = `${code} ${step} ${i} ${j}`;
        const coordinate: Position = [(i + (j % 2 === 0 ? 0.25 : -0.25)) * step, j * step];
        kept.set(key, this.known.get(key) ?? stand(code, coordinate));
      }
    }
    this.known = kept;
    this.shown = { window, stands: [...kept.values()] };
    return this.shown.stands;
  }
}

function stand(code: ProjectionCode, coordinate: Position): Stand {
  const place = unproject(code, coordinate);
  return { coordinate, place, north_rad: northAngle(code, place) };
}

function paint(frame: Frame, stands: Stand[]): void {
  const pair = currents.peek();
  if (!pair) return;
  const paths = [new Path2D(), new Path2D(), new Path2D()];
  for (const { coordinate, place, north_rad } of stands) {
    const east = samplePair(pair, 0, place[0], place[1]);
    const north = samplePair(pair, 1, place[0], place[1]);
    const strength = Math.hypot(east, north);
    if (!(strength >= 0.005)) continue;

    const [x, y] = rotateByNorth(north_rad, east, north);
    const [px, py] = frame.toPixel(coordinate);
    const [tipX, tipY] = frame.toPixel([coordinate[0] + x * frame.resolution, coordinate[1] + y * frame.resolution]);
    const direction: [number, number] = [(tipX - px) / strength, (tipY - py) / strength];
    const path = paths[currentLimits_m_s.filter((limit) => strength > limit).length];
    if (path) addArrow(path, [px, py], direction, Math.min(32, 9 + 38 * strength));
  }
  const { context } = frame;
  context.lineCap = 'round';
  paths.forEach((path, i) => {
    context.strokeStyle = palette.peek().currents[i] ?? '';
    context.lineWidth = 1.1 + 0.35 * i;
    context.stroke(path);
  });
}

function addArrow(path: Path2D, [px, py]: [number, number], [dx, dy]: [number, number], length: number): void {
  const [tipX, tipY] = [px + (dx * length) / 2, py + (dy * length) / 2];
  const head = Math.min(6, 2.5 + length / 6);
  path.moveTo(px - (dx * length) / 2, py - (dy * length) / 2);
  path.lineTo(tipX, tipY);
  for (const side of [-1, 1]) {
    path.moveTo(tipX, tipY);
    path.lineTo(tipX - head * (dx * 0.85 + side * dy * 0.5), tipY - head * (dy * 0.85 - side * dx * 0.5));
  }
}
