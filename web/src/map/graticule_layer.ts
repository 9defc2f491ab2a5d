import { effect } from '@preact/signals';
import type { Box, Position } from '../contract/data_types';
import { width_deg } from '../geo/boxes';
import { wrapLongitude } from '../geo/geodesic';
import { project, projections } from '../geo/projections';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { noteHeight_px, toolsReach_px, view } from '../model/view';
import { palette } from '../theme/palette';
import { CanvasLayer, type Frame } from './canvas_layer';

const steps_deg = [30, 20, 10, 5, 2, 1, 0.5, 1 / 3, 1 / 6, 1 / 12, 1 / 30, 1 / 60];

/** Widest step that gives at least `least` lines over a span. */
function stepFor(span_deg: number, least: number): number {
  return steps_deg.find((step) => span_deg / step >= least) ?? 1 / 60;
}

/** Meridians and parallels with their labels along the frame: meridians below, parallels on the left. */
export function graticuleLayer(): CanvasLayer {
  const layer = new CanvasLayer((frame) => {
    const seen = view.peek();
    if (seen) paint(frame, seen.box);
  }, 3);
  effect(() => {
    layer.setVisible(visible.value.graticule);
  });
  for (const cause of [view, palette, projection, toolsReach_px, noteHeight_px]) cause.subscribe(() => layer.changed());
  return layer;
}

function paint(frame: Frame, box: Box): void {
  const code = projection.peek();
  const limit_deg = projections[code].polar ? 89.999 : 85;
  const [south, north] = [Math.max(box[1], projections[code].polar ? 35 : -85), Math.min(box[3], limit_deg)];
  const width = width_deg(box);
  const lonStep = width >= 180 ? 30 : stepFor(width, 4);
  const latStep = stepFor(north - south, 4);
  const toPixel = (place: Position): [number, number] => frame.toPixel(project(code, place));

  const labels = new Labels(frame);
  frame.context.lineWidth = 1;
  frame.context.strokeStyle = palette.peek().graticule;
  const first = Math.ceil((box[0] - 1e-9) / lonStep) * lonStep;
  for (let k = 0; k <= Math.ceil(width / lonStep); ++k) {
    const lon = wrapLongitude(first + k * lonStep);
    const most = lon % 90 === 0 ? limit_deg : Math.min(limit_deg, 88);
    const line = along(48, (share) => toPixel([lon, south + (Math.min(north, most) - south) * share]));
    stroke(frame.context, line);
    labels.atBottom(line, angleText(lon, 'E', 'W', lonStep));
  }
  for (let k = Math.ceil(south / latStep); k * latStep <= north; ++k) {
    const lat = k * latStep;
    const line = along(width > 90 ? 240 : 64, (share) => toPixel([box[0] + width * share, lat]));
    stroke(frame.context, line);
    labels.atLeft(line, angleText(lat, 'N', 'S', latStep));
  }
}

function along(pieces: number, at: (share: number) => [number, number]): [number, number][] {
  return Array.from({ length: pieces + 1 }, (_, i) => at(i / pieces));
}

function stroke(context: CanvasRenderingContext2D, line: [number, number][]): void {
  context.beginPath();
  for (const [x, y] of line) context.lineTo(x, y);
  context.stroke();
}

function angleText(value: number, positive: string, negative: string, step_deg: number): string {
  const minutes = Math.round(Math.abs(value) * 60);
  const letter = minutes === 0 || minutes === 180 * 60 ? '' : value < 0 ? negative : positive;
  const degrees = `${Math.floor(minutes / 60)}°`;
  return step_deg >= 1 ? `${degrees}${letter}` : `${degrees}${String(minutes % 60).padStart(2, '0')}′${letter}`;
}

/** Where the middle of a label stands beside the frame, or beside the map's tools where these would cover it. */
const frameLeft_px = 24;
const halfHeight_px = 8;

/** Writes each label where its line meets the frame, without overlaps. */
class Labels {
  private readonly taken: { x: number; y: number; half: number }[] = [];

  constructor(private readonly frame: Frame) {}

  atBottom(line: [number, number][], text: string): void {
    const y = this.frame.height - noteHeight_px.peek() - 12;
    const x = crossing(line, 1, y);
    if (x !== undefined && x > 60 && x < this.frame.width - 24) this.write(x, y, text);
  }

  atLeft(line: [number, number][], text: string): void {
    const beside = crossing(line, 0, frameLeft_px);
    const tools = toolsReach_px.peek();
    const isHidden = beside !== undefined && beside < tools.bottom + halfHeight_px;
    const x = isHidden ? frameLeft_px + tools.right : frameLeft_px;
    const y = isHidden ? crossing(line, 0, x) : beside;
    if (y !== undefined && y > 12 && y < this.frame.height - noteHeight_px.peek() - 40) this.write(x, y, text);
  }

  private write(x: number, y: number, text: string): void {
    const { context } = this.frame;
    context.font = '11px system-ui, sans-serif';
    const half = context.measureText(text).width / 2 + 6;
    if (this.taken.some((other) => Math.abs(other.x - x) < other.half + half && Math.abs(other.y - y) < 16)) return;
    this.taken.push({ x, y, half });
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.lineWidth = 3;
    context.lineJoin = 'round';
    context.strokeStyle = palette.peek().halo;
    context.strokeText(text, x, y);
    context.fillStyle = palette.peek().label;
    context.fillText(text, x, y);
    context.strokeStyle = palette.peek().graticule;
    context.lineWidth = 1;
  }
}

/** The other coordinate where a line crosses `value` along one axis. */
function crossing(line: [number, number][], axis: 0 | 1, value: number): number | undefined {
  for (let i = 1; i < line.length; ++i) {
    const [from, to] = [line[i - 1], line[i]];
    if (!from || !to || (from[axis] - value) * (to[axis] - value) > 0 || from[axis] === to[axis]) continue;
    const share = (value - from[axis]) / (to[axis] - from[axis]);
    const other = axis === 0 ? 1 : 0;
    return from[other] + (to[other] - from[other]) * share;
  }
  return undefined;
}
