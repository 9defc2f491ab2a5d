import { describe, expect, it } from 'vitest';
import { addAreaAbove, addLineAt, addUnknown, type Lattice, type Sink } from '../../src/geo/contours';

/** Takes shapes as closed and open lines of places; rectangles become rings. */
class Lines implements Sink {
  readonly lines: { points: [number, number][]; closed: boolean }[] = [];
  moveTo(x: number, y: number): void {
    this.lines.push({ points: [[x, y]], closed: false });
  }
  lineTo(x: number, y: number): void {
    this.lines.at(-1)?.points.push([x, y]);
  }
  closePath(): void {
    const line = this.lines.at(-1);
    if (line) line.closed = true;
  }
  rect(x: number, y: number, width: number, height: number): void {
    this.lines.push({ points: [[x, y], [x + width, y], [x + width, y + height], [x, y + height]], closed: true });
  }
  /** Twice the sum of the signed areas: pieces that run the other way round would count against the rest. */
  area(): number {
    return this.lines.reduce((sum, { points }) => sum + points.reduce((part, [x, y], i) => {
      const [nextX, nextY] = points[(i + 1) % points.length] ?? [NaN, NaN];
      return part + x * nextY - nextX * y;
    }, 0) / 2, 0);
  }
}

function lattice(nx: number, ny: number, at: (x: number, y: number) => number): Lattice {
  return { nx, ny, values: Float32Array.from({ length: nx * ny }, (_, i) => at(i % nx, Math.floor(i / nx))) };
}

/** Repeatable numbers from 0 to 1 (mulberry32). */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let word = Math.imul(state ^ (state >>> 15), 1 | state);
    word = (word + Math.imul(word ^ (word >>> 7), 61 | word)) ^ word;
    return ((word ^ (word >>> 14)) >>> 0) / 4294967296;
  };
}

describe('the area above a level', () => {
  it('is that of the half plane of a slope', () => {
    const area = new Lines();
    addAreaAbove(lattice(11, 6, (x) => x), 3.25, area);
    expect(area.area()).toBeCloseTo((10 - 3.25) * 5, 4);
  });

  it('and the area below it are the whole, whatever the values', () => {
    for (let seed = 1; seed <= 200; ++seed) {
      const next = random(seed);
      const field = lattice(9, 7, () => next());
      const above = new Lines();
      const below = new Lines();
      addAreaAbove(field, 0.5, above);
      addAreaAbove({ ...field, values: field.values.map((value) => 1 - value) }, 0.5, below);
      // At a saddle both take the corners to be joined: the middle, which is less than the cell, counts twice.
      let saddles = 0;
      for (let j = 0; j < 6; ++j) {
        for (let i = 0; i < 8; ++i) {
          const at = (di: number, dj: number): boolean => (field.values[(j + dj) * 9 + i + di] ?? 0) >= 0.5;
          if (at(0, 0) === at(1, 1) && at(1, 0) === at(0, 1) && at(0, 0) !== at(1, 0)) ++saddles;
        }
      }
      const sum = above.area() + below.area();
      expect(sum, `seed ${seed}`).toBeGreaterThan(48 - 1e-4);
      expect(sum, `seed ${seed}`).toBeLessThan(48 + saddles + 1e-4);
    }
  });

  it('leaves out the cells that lack a value, and those are told', () => {
    const field = lattice(5, 5, (x, y) => (x === 2 && y === 2 ? NaN : 1));
    const area = new Lines();
    const unknown = new Lines();
    addAreaAbove(field, 0.5, area);
    addUnknown(field, unknown);
    expect(area.area()).toBe(12);
    expect(unknown.area()).toBe(4);
  });
});

describe('the line at a level', () => {
  it('is one closed line round a hill, at its distance', () => {
    const line = new Lines();
    addLineAt(lattice(21, 21, (x, y) => Math.hypot(x - 10, y - 10)), 6.5, line);
    expect(line.lines).toHaveLength(1);
    expect(line.lines[0]?.closed).toBe(true);
    for (const [x, y] of line.lines[0]?.points ?? []) expect(Math.hypot(x - 10, y - 10)).toBeCloseTo(6.5, 1);
  });

  it('is one open line from edge to edge', () => {
    const line = new Lines();
    addLineAt(lattice(8, 5, (x) => x), 2.5, line);
    expect(line.lines).toHaveLength(1);
    expect(line.lines[0]?.points).toHaveLength(5);
    for (const [x] of line.lines[0]?.points ?? []) expect(x).toBe(2.5);
  });

  it('encloses the area above the level', () => {
    for (let seed = 1; seed <= 100; ++seed) {
      const next = random(seed);
      const rim = (x: number, y: number): boolean => x === 0 || y === 0 || x === 8 || y === 8;
      const field = lattice(9, 9, (x, y) => (rim(x, y) ? 0 : next()));
      const area = new Lines();
      const line = new Lines();
      addAreaAbove(field, 0.5, area);
      addLineAt(field, 0.5, line);
      expect(line.lines.every(({ closed }) => closed), `seed ${seed}`).toBe(true);
      expect(Math.abs(line.area()), `seed ${seed}`).toBeCloseTo(area.area(), 4);
    }
  });
});
