import { computed, effect, type ReadonlySignal } from '@preact/signals';
import type { IcebergDrift, Position } from '../contract/data_types';
import { project, scaleFactor } from '../geo/projections';
import { time_ms } from '../model/clock';
import { driftLineOf, drifts, errorAt, plainLineOf, stepsAt, ticksOf } from '../model/ice/drift';
import { crowd, keepOut_m } from '../model/ice/icebergs';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { minute_ms } from '../model/time';
import { palette } from '../theme/palette';
import { CanvasLayer, screenMatrix, type Frame } from './canvas_layer';
import { toMap } from './projections';

/**
 * Beyond this many metres per pixel, rings would hide the map (rings_m); so would ticks and the loops of tidal drift
 * (tides_m).
 */
const rings_m = 150;
const tides_m = 60;

/** Beyond this, all drift lines would hide the map where bergs are close together. */
const lines_m = 300;

/** Opacity of rings and lines: many overlap, and plans below must stay visible. */
const most = 'b0';
const half = '80';

const isShown = computed(() => visible.value.drift && visible.value.icebergs);

/** Lines of very many bergs would hide the map; only their expected positions are shown. */
const hasLines = computed(() => isShown.value && drifts.value.length <= crowd);

/** The lines of all bergs in metres from a place among them, because a canvas draws large coordinates less exactly. */
interface Lines {
  origin: Position;
  plain: Path2D;
  tidal: Path2D;
  ticks: Path2D;
}

const linesNow = computed<Lines | undefined>(() => {
  const code = projection.value;
  const [first] = drifts.value.flatMap(driftLineOf);
  if (!hasLines.value || !first) return undefined;
  const lines: Lines = { origin: project(code, first), plain: new Path2D(), tidal: new Path2D(), ticks: new Path2D() };
  const [x0, y0] = lines.origin;
  const placed = (places: Position[]): Position[] => toMap(code, places).map(([x, y]) => [x - x0, y - y0]);
  const addLine = (path: Path2D, places: Position[]): void =>
    placed(places).forEach(([x, y], i) => {
      if (i === 0) path.moveTo(x, y);
      else path.lineTo(x, y);
    });
  for (const drift of drifts.value) {
    addLine(lines.plain, plainLineOf(drift));
    addLine(lines.tidal, driftLineOf(drift));
    for (const [x, y] of placed(ticksOf(drift))) {
      lines.ticks.moveTo(x, y);
      lines.ticks.lineTo(x, y); // drawn as a dot by the round line cap
    }
  }
  return lines;
});

/**
 * The forecast track of each berg: a thin line with a tick every six hours; at small scales a pale line without the
 * tides.
 */
export function driftLayer(): CanvasLayer {
  return painting((frame) => paintLines(frame, linesNow.peek()), [linesNow, palette]);
}

function paintLines(frame: Frame, lines: Lines | undefined): void {
  const { context, resolution } = frame;
  if (!lines || resolution >= lines_m) return;
  const { reach } = palette.peek();
  const [x, y] = lines.origin;
  const matrix = screenMatrix(frame, [x, y], [x + 1, y], [x, y + 1]);
  const stroke = (path: Path2D, colour: string, width: number): void => {
    const onScreen = new Path2D();
    onScreen.addPath(path, matrix);
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke(onScreen);
  };
  context.lineCap = 'round';
  context.lineJoin = 'round';
  if (resolution >= tides_m) {
    stroke(lines.plain, reach + half, 1);
    return;
  }
  stroke(lines.tidal, reach, 1);
  stroke(lines.ticks, reach, 3.6);
}

/**
 * The forecast of a berg on the map. Between hourly steps it is a straight line, within metres of the geodesic. The
 * projections preserve angles, so a circle of some kilometres stays a circle, within a thousandth of its radius.
 */
interface Track {
  drift: IcebergDrift;
  places: Position[];
  scale: number;
  observed_ms: number;
}

const tracksNow = computed<Track[]>(() => {
  const code = projection.value;
  return drifts.value.map((drift) => {
    const line = driftLineOf(drift);
    return { drift, places: toMap(code, line), scale: scaleFactor(code, line[0] ?? [0, 0]), observed_ms: Date.parse(drift.observed) };
  });
});

/** Numbers for each berg in the list of ghosts: its expected position in the projection, and its keep-out radius there. */
const perGhost = 3;

/** In one array of numbers: a playing clock makes it anew in every frame. */
const ghostsNow = computed<Float64Array>(() => {
  if (!isShown.value) return new Float64Array();
  const tracks = tracksNow.value;
  const minute = Math.round(time_ms.value / minute_ms) * minute_ms;
  const ghosts = new Float64Array(perGhost * tracks.length);
  let used = 0;
  for (const { drift, places, scale, observed_ms } of tracks) {
    const steps = minute > observed_ms ? stepsAt(drift, minute) : undefined;
    if (!steps) continue;
    const to = places[steps.after];
    const from = places[steps.after - 1] ?? to;
    if (!from || !to) continue;
    ghosts[used] = from[0] + steps.share * (to[0] - from[0]);
    ghosts[used + 1] = from[1] + steps.share * (to[1] - from[1]);
    ghosts[used + 2] = keepOut_m(drift.safe_length_m, errorAt(drift, steps)) * scale;
    used += perGhost;
  }
  return ghosts.subarray(0, used);
});

/**
 * The expected position of each berg at the clock's time, with its keep-out circle, which grows with the position
 * error.
 */
export function ghostLayer(): CanvasLayer {
  return painting((frame) => paintGhosts(frame, ghostsNow.peek()), [ghostsNow, palette]);
}

/** A triangle that points up, of this radius: half its base, and how far the base lies below its middle. */
const ghost_px = 7;
const halfBase_px = ghost_px * Math.cos(Math.PI / 6);
const base_px = ghost_px / 2;

function paintGhosts(frame: Frame, ghosts: Float64Array): void {
  const { context, resolution, width, height } = frame;
  const { reach, berg } = palette.peek();
  const hasRings = resolution < rings_m;
  const [rings, marks] = [new Path2D(), new Path2D()];
  const { a, b, c, d, e, f } = screenMatrix(frame, [0, 0], [1, 0], [0, 1]);
  for (let i = 0; i < ghosts.length; i += perGhost) {
    const [east, north, radius] = [ghosts[i] ?? NaN, ghosts[i + 1] ?? NaN, ghosts[i + 2] ?? NaN];
    const x = a * east + c * north + e;
    const y = b * east + d * north + f;
    const ring_px = radius / resolution;
    const room_px = hasRings ? Math.max(ring_px, ghost_px) : ghost_px;
    if (x < -room_px || y < -room_px || x > width + room_px || y > height + room_px) continue;
    if (hasRings) {
      rings.moveTo(x + ring_px, y);
      rings.arc(x, y, ring_px, 0, 2 * Math.PI);
    }
    marks.moveTo(x, y - ghost_px);
    marks.lineTo(x + halfBase_px, y + base_px);
    marks.lineTo(x - halfBase_px, y + base_px);
    marks.lineTo(x, y - ghost_px); // cheaper than closing the path, which is dashed anyway
  }
  context.lineJoin = 'miter';
  if (hasRings) {
    context.setLineDash([4, 4]);
    context.lineWidth = 1.2;
    context.strokeStyle = reach + most;
    context.stroke(rings);
  }
  context.fillStyle = berg;
  context.fill(marks);
  context.setLineDash([4, 2]);
  context.lineWidth = 1.6;
  context.strokeStyle = reach;
  context.stroke(marks);
  context.setLineDash([]);
}

/** A layer above the areas and below the plans, repainted when one of `causes` has changed. */
function painting(paint: (frame: Frame) => void, causes: ReadonlySignal<unknown>[]): CanvasLayer {
  const layer = new CanvasLayer(paint, 5);
  effect(() => layer.setVisible(isShown.value));
  for (const cause of causes) cause.subscribe(() => layer.changed());
  return layer;
}
