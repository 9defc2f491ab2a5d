import { effect } from '@preact/signals';
import { SampledPlaces } from '../geo/grid';
import { northAngle, unproject, type ProjectionCode } from '../geo/projections';
import { rotateByNorth } from '../geo/vectors';
import { currents } from '../model/field';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import type { Position } from '../contract/data_types';
import { currentLimits_m_s, palette } from '../theme/palette';
import { CanvasLayer, screenMatrix, type Frame } from './canvas_layer';

/** Least distance between arrows on the screen. */
const spacing_px = 34;

/** Slower currents have no arrow: their direction means nothing. */
const slowest_m_s = 0.005;

/** Where an arrow stands, in the projection, and the directions of true east and north there, as vectors of length one. */
interface Stand {
  place: Position;
  x: number;
  y: number;
  eastX: number;
  eastY: number;
  northX: number;
  northY: number;
}

/** The stands in view with the currents at them. */
interface Shown {
  window: string;
  stands: Stand[];
  east_m_s: SampledPlaces;
  north_m_s: SampledPlaces;
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
  private shown: Shown | undefined;

  within(frame: Frame, code: ProjectionCode): Shown {
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
    if (this.shown?.window === window) return this.shown;

    const kept = new Map<string, Stand>();
    for (let j = south; j <= north; ++j) {
      for (let i = west; i <= east; ++i) {
        const key = `${code} ${step} ${i} ${j}`;
        const coordinate: Position = [(i + (j % 2 === 0 ? 0.25 : -0.25)) * step, j * step];
        kept.set(key, this.known.get(key) ?? stand(code, coordinate));
      }
    }
    this.known = kept;
    const stands = [...kept.values()];
    const [lons, lats] = ([0, 1] as const).map((axis) => Float64Array.from(stands, ({ place }) => place[axis])) as [Float64Array, Float64Array];
    this.shown = { window, stands, east_m_s: new SampledPlaces(0, lons, lats), north_m_s: new SampledPlaces(1, lons, lats) };
    return this.shown;
  }
}

function stand(code: ProjectionCode, coordinate: Position): Stand {
  const place = unproject(code, coordinate);
  const north_rad = northAngle(code, place);
  const [x, y] = coordinate;
  const [[eastX, eastY], [northX, northY]] = [rotateByNorth(north_rad, 1, 0), rotateByNorth(north_rad, 0, 1)];
  return { place, x, y, eastX, eastY, northX, northY };
}

function paint(frame: Frame, { stands, east_m_s, north_m_s }: Shown): void {
  const pair = currents.peek();
  if (!pair) return;
  const { context, resolution } = frame;
  const [easts, norths] = [east_m_s.at(pair), north_m_s.at(pair)];
  const paths = [new Path2D(), new Path2D(), new Path2D()];
  const { a, b, c, d, e, f } = screenMatrix(frame, [0, 0], [1, 0], [0, 1]);
  let i = -1;
  for (const { x, y, eastX, eastY, northX, northY } of stands) {
    const [toEast, toNorth] = [easts[++i] ?? NaN, norths[i] ?? NaN];
    const strength = Math.sqrt(toEast * toEast + toNorth * toNorth);
    const path = paths[rankOf(strength)];
    if (!(strength >= slowest_m_s) || !path) continue;
    const [u, v] = [(toEast * eastX + toNorth * northX) / strength, (toEast * eastY + toNorth * northY) / strength];
    addArrow(path, a * x + c * y + e, b * x + d * y + f, (a * u + c * v) * resolution, (b * u + d * v) * resolution, Math.min(32, 9 + 38 * strength));
  }
  context.lineCap = 'round';
  paths.forEach((path, i) => {
    context.strokeStyle = palette.peek().currents[i] ?? '';
    context.lineWidth = 1.1 + 0.35 * i;
    context.stroke(path);
  });
}

/** Which of the classes of strength a current belongs to. */
function rankOf(strength: number): number {
  let rank = 0;
  while (strength > (currentLimits_m_s[rank] ?? Infinity)) ++rank;
  return rank;
}

/** Adds an arrow around a pixel, of a direction (length one) and a length in pixels. */
function addArrow(path: Path2D, px: number, py: number, dx: number, dy: number, length: number): void {
  const [tipX, tipY] = [px + (dx * length) / 2, py + (dy * length) / 2];
  const head = Math.min(6, 2.5 + length / 6);
  path.moveTo(px - (dx * length) / 2, py - (dy * length) / 2);
  path.lineTo(tipX, tipY);
  for (const side of [-1, 1]) {
    path.moveTo(tipX, tipY);
    path.lineTo(tipX - head * (dx * 0.85 + side * dy * 0.5), tipY - head * (dy * 0.85 - side * dx * 0.5));
  }
}
