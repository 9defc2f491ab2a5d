import { computed, effect } from '@preact/signals';
import { addAreaAbove, addLineAt, addUnknown, type Lattice } from '../geo/contours';
import { SampledPlaces, type TimedPair } from '../geo/grid';
import { PlaceLattice } from '../geo/place_lattice';
import type { ProjectionCode } from '../geo/projections';
import { playing } from '../model/clock';
import { chosenSeaIce } from '../model/datasets';
import { seaIce } from '../model/field';
import { visible } from '../model/layers';
import { iceEdge, seaIceLevels, surfacingLimit } from '../model/ice/sea_ice';
import { projection } from '../model/settings';
import { palette, seaIceHatches, surfacingDash, unknownHatch, type Hatch } from '../theme/palette';
import { CanvasLayer, screenMatrix, type Frame } from './canvas_layer';

/** Least distance on the screen between nodes at which the ice is sampled. */
const spacing_px = 7;

/** Number of redraws between two time steps; smaller changes would not be visible. */
const stages = 100;

/** Distance between two thickness labels, in nodes. */
const figuresApart = { columns: 12, rows: 7 };

/** Exact positions are computed every this many nodes (about forty pixels), the others interpolated. */
const exactApart = 6;

/**
 * Sea ice at the clock's time: denser hatching for higher concentration, thickness as numbers, the ice edge, and the
 * line beyond which the vehicle may not surface. Dashes mark missing data, so that blank means open water.
 */
export function seaIceLayer(): CanvasLayer {
  const stand = new Stand();
  let shown: TimedPair | undefined;
  const staged = computed(() => {
    const now = seaIce.value && { ...seaIce.value, share: Math.round(seaIce.value.share * stages) / stages };
    if (!isSame(shown, now)) shown = now;
    return shown;
  });
  const layer = new CanvasLayer((frame) => paint(frame, stand, staged.peek()), 0.5);
  effect(() => {
    layer.setVisible(visible.value.seaIce && chosenSeaIce.value !== undefined);
  });
  for (const cause of [palette, projection, surfacingLimit]) cause.subscribe(() => layer.changed());
  let underWay = false;
  const makeParts = (): void => {
    underWay = !stand.makePart(staged.peek(), surfacingLimit.peek());
    if (underWay) {
      requestAnimationFrame(makeParts);
      return;
    }
    layer.changed();
    follow();
  };
  const follow = (): void => {
    if (!playing.peek()) {
      layer.changed();
    } else if (!underWay && !stand.isOf(staged.peek())) {
      underWay = true;
      requestAnimationFrame(makeParts);
    }
  };
  staged.subscribe(follow);
  playing.subscribe(follow);
  return layer;
}

/** The nodes in view, numbered on a lattice of the projection that does not move with the map. */
interface Nodes {
  code: ProjectionCode;
  step: number; // metres of the projection
  left: number; // number of the first column from the projection's origin
  top: number; // and of the first row, downwards
  nx: number;
  ny: number;
}

/** A thickness label's position in lattice units. */
interface Sounding {
  x: number;
  y: number;
}

/** The shapes at one time, in lattice units. */
interface Shapes {
  areas: { path: Path2D; hatch: Hatch }[];
  unknown: Path2D;
  edge: Path2D;
  limit: Path2D;
  figures: { x: number; y: number; text: string }[];
}

type Drawn = Omit<Shapes, 'figures'>;

/**
 * What is kept between frames: positions change with the view, values with the data, shapes with the clock. While the clock plays, each frame
 * computes a part of the next shapes, and the last complete ones are painted.
 */
class Stand {
  private nodes: Nodes | undefined;
  private soundings: Sounding[] = [];
  private concentration = new SampledPlaces(0, new Float64Array(), new Float64Array());
  private thickness_m = this.concentration;
  private drawn: { pair: TimedPair | undefined; limit: number; shapes: Shapes } | undefined;
  private making: { pair: TimedPair | undefined; limit: number; parts: Generator<undefined, Shapes> } | undefined;

  at(frame: Frame, code: ProjectionCode): Nodes {
    const step = 2 ** (Math.ceil(2 * Math.log2(spacing_px * frame.resolution)) / 2);
    const corners = ([[0, 0], [frame.width, 0], [0, frame.height], [frame.width, frame.height]] as const).map((corner) => frame.toCoordinate(corner));
    const columns = corners.map(([x]) => x / step);
    const rows = corners.map(([, y]) => -y / step);
    const [left, right, top, bottom] = [Math.floor(Math.min(...columns)), Math.ceil(Math.max(...columns)), Math.floor(Math.min(...rows)), Math.ceil(Math.max(...rows))];
    const now = this.nodes;
    const serves =
      now?.code === code && now.step === step && now.left <= left && now.top <= top && now.left + now.nx > right && now.top + now.ny > bottom;
    if (now && serves) return now;

    const rim = Math.ceil((right - left) / 8);
    const nodes = { code, step, left: left - rim, top: top - rim, nx: right - left + 1 + 2 * rim, ny: bottom - top + 1 + 2 * rim };
    this.nodes = nodes;
    this.settle(nodes);
    return nodes;
  }

  shapesOf(nodes: Nodes, now: TimedPair | undefined, limit: number): Shapes {
    const { drawn } = this;
    if (drawn && drawn.limit === limit && (drawn.pair === now || playing.peek())) return drawn.shapes;
    const parts = this.shaped(nodes, now, limit);
    for (;;) {
      const { done, value } = parts.next();
      if (done) return this.take(now, limit, value);
    }
  }

  isOf = (now: TimedPair | undefined): boolean => this.drawn !== undefined && this.drawn.pair === now;

  /** Computes one more part of the shapes for a time. True: all parts are ready to be painted. */
  makePart(now: TimedPair | undefined, limit: number): boolean {
    if (!this.nodes || !this.drawn) return true;
    this.making ??= { pair: now, limit, parts: this.shaped(this.nodes, now, limit) };
    const { pair, limit: of, parts } = this.making;
    const { done, value } = parts.next();
    if (done) this.take(pair, of, value);
    return done === true;
  }

  private take(pair: TimedPair | undefined, limit: number, shapes: Shapes): Shapes {
    this.making = undefined;
    this.drawn = { pair, limit, shapes };
    return shapes;
  }

  private settle({ code, step, left, top, nx, ny }: Nodes): void {
    const places = new PlaceLattice(code, (left - 0.5) * step, (0.5 - top) * step, step, nx, ny, exactApart);
    const [lons, lats] = [new Float64Array(nx * ny), new Float64Array(nx * ny)];
    this.soundings = [];
    for (let j = 0; j < ny; ++j) {
      places.enterRow(j);
      for (let i = 0; i < nx; ++i) {
        lons[j * nx + i] = places.lon(i);
        lats[j * nx + i] = places.lat(i);
        if ((left + i) % figuresApart.columns === 0 && (top + j) % figuresApart.rows === 0) this.soundings.push({ x: i, y: j });
      }
    }
    const ofSoundings = (values: Float64Array): Float64Array => Float64Array.from(this.soundings, ({ x, y }) => values[y * nx + x] ?? NaN);
    this.concentration = new SampledPlaces(0, lons, lats);
    this.thickness_m = new SampledPlaces(1, ofSoundings(lons), ofSoundings(lats));
    this.drawn = undefined;
    this.making = undefined;
  }

  private *shaped({ nx, ny }: Nodes, pair: TimedPair | undefined, limit: number): Generator<undefined, Shapes> {
    const concentration = pair ? this.concentration.at(pair) : new Float32Array(nx * ny).fill(NaN);
    const lattice: Lattice = { nx, ny, values: concentration };
    const shapes: Shapes = { areas: [], unknown: new Path2D(), edge: new Path2D(), limit: new Path2D(), figures: [] };
    yield;
    addUnknown(lattice, shapes.unknown);
    let most = 0;
    for (const value of concentration) if (value > most) most = value;
    for (const [k, level] of seaIceLevels.entries()) {
      const hatch = seaIceHatches[k];
      if (most < level || !hatch) continue;
      yield;
      const path = new Path2D();
      addAreaAbove(lattice, level, path);
      shapes.areas.push({ path, hatch });
    }
    yield;
    addLineAt(lattice, iceEdge, shapes.edge);
    yield;
    addLineAt(lattice, limit, shapes.limit);
    if (pair) shapes.figures = this.figures(pair, lattice);
    return shapes;
  }

  private figures(pair: TimedPair, { nx, values }: Lattice): Shapes['figures'] {
    const thickness_m = this.thickness_m.at(pair);
    return this.soundings.flatMap(({ x, y }, i) => {
      if (!((values[y * nx + x] ?? NaN) >= iceEdge)) return [];
      const here_m = thickness_m[i] ?? NaN;
      return [{ x, y, text: Number.isNaN(here_m) ? '?' : here_m.toFixed(1) }];
    });
  }
}

const isSame = (a: TimedPair | undefined, b: TimedPair | undefined): boolean => a?.before === b?.before && a?.after === b?.after && a?.share === b?.share;

function paint(frame: Frame, stand: Stand, now: TimedPair | undefined): void {
  const { context } = frame;
  const nodes = stand.at(frame, projection.peek());
  const { seaIce: colours, ink, casing, halo } = palette.peek();
  const shapes = stand.shapesOf(nodes, now, surfacingLimit.peek());
  const { step, left, top } = nodes;
  const place = (x: number, y: number): [number, number] => [(left + x) * step, -(top + y) * step];
  const drawn = moved(shapes, screenMatrix(frame, place(0, 0), place(1, 0), place(0, 1)));
  const anchor = frame.toPixel([0, 0]); // the hatching moves with the map

  context.fillStyle = hatching(context, unknownHatch, colours.unknown, anchor);
  context.fill(drawn.unknown);
  for (const { path, hatch } of drawn.areas) {
    context.fillStyle = colours.veil;
    context.fill(path);
    context.fillStyle = hatching(context, hatch, colours.hatch, anchor);
    context.fill(path);
  }
  context.lineJoin = 'round';
  stroke(context, drawn.limit, casing, 3.4, []);
  stroke(context, drawn.edge, colours.edge, 1.2, []);
  stroke(context, drawn.limit, ink, 2, surfacingDash);

  context.font = '600 11px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = halo;
  context.fillStyle = colours.figure;
  for (const { x, y, text } of shapes.figures) {
    const [px, py] = frame.toPixel(place(x, y));
    context.strokeText(text, px, py);
    context.fillText(text, px, py);
  }
}

/** The shapes in pixels. */
function moved({ areas, unknown, edge, limit }: Shapes, matrix: DOMMatrix): Drawn {
  const copyOf = (path: Path2D): Path2D => {
    const copy = new Path2D();
    copy.addPath(path, matrix);
    return copy;
  };
  return { areas: areas.map(({ path, hatch }) => ({ path: copyOf(path), hatch })), unknown: copyOf(unknown), edge: copyOf(edge), limit: copyOf(limit) };
}

function stroke(context: CanvasRenderingContext2D, path: Path2D, colour: string, width: number, dash: readonly number[]): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash([...dash]);
  context.stroke(path);
  context.setLineDash([]);
}

const patterns = new Map<string, CanvasPattern>();

/** The pattern of a hatch, cached by colour and screen resolution. */
function hatching(context: CanvasRenderingContext2D, { tile_px, marks, width }: Hatch, colour: string, [x, y]: [number, number]): CanvasPattern | string {
  const sharpness = window.devicePixelRatio;
  const key = `${marks} ${tile_px} ${colour} ${sharpness}`;
  const made = patterns.get(key) ?? makePattern(context, marks, tile_px, width, colour, sharpness);
  if (!made) return 'transparent';
  patterns.set(key, made);
  made.setTransform(new DOMMatrix().translate(x % tile_px, y % tile_px).scale(1 / sharpness));
  return made;
}

function makePattern(context: CanvasRenderingContext2D, marks: string, tile_px: number, width: number, colour: string, sharpness: number): CanvasPattern | null {
  const tile = document.createElement('canvas');
  tile.width = tile.height = Math.round(tile_px * sharpness);
  const brush = tile.getContext('2d');
  if (!brush) return null;
  brush.scale(tile.width / tile_px, tile.height / tile_px);
  brush.strokeStyle = colour;
  brush.lineWidth = width;
  brush.lineCap = 'round';
  brush.stroke(new Path2D(marks));
  return context.createPattern(tile, 'repeat');
}
