import type { FrameState } from 'ol/Map.js';
import Layer from 'ol/layer/Layer.js';
import Source from 'ol/source/Source.js';
import { LastDrawn } from './last_drawn';

/** One frame to be painted, in CSS pixels with the origin at the upper left of the map. */
export interface Frame {
  context: CanvasRenderingContext2D;
  width: number;
  height: number;
  resolution: number; // projected metres per pixel
  toPixel(coordinate: readonly [number, number]): [number, number];
  toCoordinate(pixel: readonly [number, number]): [number, number];
}

/**
 * The matrix from units along two axes to pixels, from the positions of the origin and of the end of one unit on each
 * axis.
 */
export function screenMatrix(frame: Frame, origin: Place, first: Place, second: Place): DOMMatrix {
  const [[x, y], [x1, y1], [x2, y2]] = [frame.toPixel(origin), frame.toPixel(first), frame.toPixel(second)];
  return new DOMMatrix([x1 - x, y1 - y, x2 - x, y2 - y, x, y]);
}

type Place = readonly [number, number];

/**
 * A layer painted by a function, only when the view has moved or `changed()` was called. Its canvas is inside a div,
 * because OpenLayers would draw the layers above into a bare canvas.
 */
export class CanvasLayer extends Layer {
  private readonly frame = document.createElement('div');
  private readonly canvas = document.createElement('canvas');
  private readonly painted = new LastDrawn();
  private paints = 0;

  constructor(private readonly paint: (frame: Frame) => void, zIndex: number) {
    super({ source: new Source({}), zIndex });
    this.frame.className = 'map-canvas';
    this.frame.append(this.canvas);
  }

  override render(state: FrameState | null): HTMLElement {
    const context = this.canvas.getContext('2d');
    if (!state || !context) return this.frame;
    const [width = 0, height = 0] = state.size;
    const ratio = state.pixelRatio;
    const { center, resolution, rotation } = state.viewState;
    if (this.painted.isFor(width, height, ratio, ...center, resolution, rotation, this.getRevision())) return this.frame;
    this.frame.dataset['layer'] = String(this.get('name'));
    this.frame.dataset['paints'] = String(++this.paints); // counted by tests

    const device = [Math.round(width * ratio), Math.round(height * ratio)] as const;
    if (this.canvas.width !== device[0] || this.canvas.height !== device[1]) [this.canvas.width, this.canvas.height] = device;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);

    const [cx = 0, cy = 0] = center;
    const cos = Math.cos(rotation);
    const sin = Math.sin(rotation);
    this.paint({
      context,
      width,
      height,
      resolution,
      toPixel: ([x, y]) => {
        const dx = (x - cx) / resolution;
        const dy = (y - cy) / resolution;
        return [width / 2 + dx * cos + dy * sin, height / 2 + dx * sin - dy * cos];
      },
      toCoordinate: ([px, py]) => {
        const sx = px - width / 2;
        const sy = height / 2 - py;
        return [cx + (sx * cos - sy * sin) * resolution, cy + (sx * sin + sy * cos) * resolution];
      },
    });
    return this.frame;
  }
}
