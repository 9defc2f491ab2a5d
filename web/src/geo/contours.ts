/** Values at the nodes of a lattice, row by row; NaN where there is none. */
export interface Lattice {
  nx: number;
  ny: number;
  values: Float32Array;
}

/** Receives shapes in lattice units, x along the columns and y along the rows; a Path2D is one. */
export interface Sink {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  closePath(): void;
  rect(x: number, y: number, width: number, height: number): void;
}

/** The corners of a cell in order around it: the edge after each corner leads to the next. */
const corners = [[0, 0], [1, 0], [1, 1], [0, 1]] as const;

const none = -1;

/** Which corners of a cell reach a level, one bit for each; `none` where a corner has no value. */
function cornersAbove({ nx, values }: Lattice, i: number, j: number, level: number): number {
  const first = j * nx + i;
  const a = values[first] ?? NaN;
  const b = values[first + 1] ?? NaN;
  const c = values[first + nx + 1] ?? NaN;
  const d = values[first + nx] ?? NaN;
  if (Number.isNaN(a + b + c + d)) return none;
  return (a >= level ? 1 : 0) | (b >= level ? 2 : 0) | (c >= level ? 4 : 0) | (d >= level ? 8 : 0);
}

/** Where the level lies on the edge after a corner, linear between the two nodes. */
function crossing({ nx, values }: Lattice, i: number, j: number, corner: number, level: number): [x: number, y: number] {
  const [fromX, fromY] = corners[corner] ?? corners[0];
  const [toX, toY] = corners[(corner + 1) % 4] ?? corners[0];
  const from = values[(j + fromY) * nx + i + fromX] ?? NaN;
  const to = values[(j + toY) * nx + i + toX] ?? NaN;
  const share = (level - from) / (to - from);
  return [i + fromX + share * (toX - fromX), j + fromY + share * (toY - fromY)];
}

/**
 * Adds the area in which the values, bilinear within a cell, reach a level. All its pieces have the same orientation,
 * so that no seam shows between them. If only two opposite corners reach it, their areas are taken to be joined.
 */
export function addAreaAbove(lattice: Lattice, level: number, sink: Sink): void {
  eachRow(lattice, (i, j) => cornersAbove(lattice, i, j, level), 15, sink, (i, j, above) => {
    let begun = false;
    const visit = (x: number, y: number): void => {
      if (begun) sink.lineTo(x, y);
      else sink.moveTo(x, y);
      begun = true;
    };
    for (let k = 0; k < 4; ++k) {
      const [x, y] = corners[k] ?? corners[0];
      if (isIn(above, k)) visit(i + x, j + y);
      if (isIn(above, k) !== isIn(above, k + 1)) visit(...crossing(lattice, i, j, k, level));
    }
    sink.closePath();
  });
}

/** Adds the cells that lack a value at one of their corners. */
export function addUnknown(lattice: Lattice, sink: Sink): void {
  eachRow(lattice, (i, j) => (cornersAbove(lattice, i, j, 0) === none ? 15 : 0), 15, sink, () => undefined);
}

const isIn = (above: number, corner: number): boolean => (above & (1 << corner % 4)) !== 0;

/**
 * Runs of cells that are completely inside become one rectangle for each row; cells that are partly inside are passed
 * to `part`.
 */
function eachRow(
  { nx, ny }: Lattice, aboveAt: (i: number, j: number) => number, whole: number, sink: Sink, part: (i: number, j: number, above: number) => void,
): void {
  for (let j = 0; j + 1 < ny; ++j) {
    let start = none;
    for (let i = 0; i + 1 < nx; ++i) {
      const above = aboveAt(i, j);
      if (above === whole) {
        if (start === none) start = i;
        continue;
      }
      if (start !== none) sink.rect(start, j, i - start, 1);
      start = none;
      if (above > 0) part(i, j, above);
    }
    if (start !== none) sink.rect(start, j, nx - 1 - start, 1);
  }
}

/** Adds the lines at a level, each as long as possible, so that it can be dashed. */
export function addLineAt(lattice: Lattice, level: number, sink: Sink): void {
  const { nx, ny } = lattice;
  const next = new Map<number, number>(); // from the edge where a line leaves a cell to the edge of its next end
  const arrived = new Set<number>();
  const places = new Map<number, [x: number, y: number]>();

  const edgeOf = (i: number, j: number, corner: number): number => {
    const isAcross = corner % 2 === 1; // between rows
    return 2 * ((j + (corner === 2 ? 1 : 0)) * nx + i + (corner === 1 ? 1 : 0)) + (isAcross ? 1 : 0);
  };
  for (let j = 0; j + 1 < ny; ++j) {
    for (let i = 0; i + 1 < nx; ++i) {
      const above = cornersAbove(lattice, i, j, level);
      if (above <= 0 || above === 15) continue;
      for (let k = 0; k < 4; ++k) {
        if (!isIn(above, k) || isIn(above, k + 1)) continue; // the line begins where the walk around the cell leaves the area
        let end = (k + 1) % 4;
        while (isIn(above, end) || !isIn(above, end + 1)) end = (end + 1) % 4;
        const [from, to] = [edgeOf(i, j, k), edgeOf(i, j, end)];
        next.set(from, to);
        arrived.add(to);
        places.set(from, crossing(lattice, i, j, k, level));
        places.set(to, crossing(lattice, i, j, end, level));
      }
    }
  }

  const follow = (start: number): void => {
    sink.moveTo(...(places.get(start) ?? [NaN, NaN]));
    for (let edge = next.get(start), from = start; edge !== undefined; from = edge, edge = next.get(edge)) {
      next.delete(from);
      if (edge === start) sink.closePath();
      else sink.lineTo(...(places.get(edge) ?? [NaN, NaN]));
    }
  };
  for (const start of [...next.keys()]) if (!arrived.has(start)) follow(start);
  for (const start of [...next.keys()]) if (next.has(start)) follow(start);
}
