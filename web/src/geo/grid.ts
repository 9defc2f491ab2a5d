/** A field on a regular longitude-latitude grid as the server sends it. Row 0 is the south, columns run west to east. */
export interface Grid {
  variables: string[];
  nx: number;
  ny: number;
  west_deg: number;
  south_deg: number;
  dx_deg: number;
  dy_deg: number;
  time: string | null;
  dataset_id: string;
  dataset_name: string;
  warnings: string[];
  values: Float32Array[]; // one per variable, NaN where the server has no value
}

interface Header extends Omit<Grid, 'values'> {
  scale: number[];
  missing: number;
}

/** Reads the server's binary grid; throws when the bytes are not one. */
export function decodeGrid(bytes: ArrayBuffer): Grid {
  if (bytes.byteLength < 4) throw new Error('The grid is cut short.');
  const view = new DataView(bytes);
  const headerLength = view.getUint32(0, true);
  if (4 + headerLength > bytes.byteLength) throw new Error('The grid is cut short.');
  const { scale, missing, ...header } = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, headerLength))) as Header;

  const count = header.nx * header.ny;
  const start = 4 + headerLength;
  if (start + 2 * count * header.variables.length > bytes.byteLength) throw new Error('The grid is cut short.');
  const values = header.variables.map((_, k) => {
    const field = new Float32Array(count);
    const factor = scale[k] ?? 1;
    for (let i = 0; i < count; ++i) {
      const raw = view.getInt16(start + 2 * (k * count + i), true);
      field[i] = raw === missing ? NaN : raw * factor;
    }
    return field;
  });
  return { ...header, values };
}

/** Column of a longitude as a fraction; outside of 0 to nx - 1 where the grid does not reach it. */
function columnOf({ west_deg, dx_deg, nx }: Grid, lon: number): number {
  const x = (lon - west_deg) / dx_deg;
  const turn = 360 / dx_deg;
  if (x < 0) return x + turn;
  return x > nx - 1 && x - turn >= 0 ? x - turn : x;
}

const mix = (from: number, to: number, share: number): number => (share === 0 ? from : from * (1 - share) + to * share);

/**
 * Bilinear value of one variable; NaN outside the grid or when any of the four corners is missing. Makes no objects,
 * because maps sample many thousand places.
 */
export function sample(grid: Grid, variable: number, lon: number, lat: number): number {
  const { nx, ny } = grid;
  const field = grid.values[variable];
  const x = columnOf(grid, lon);
  const y = (lat - grid.south_deg) / grid.dy_deg;
  if (!field || !(x >= 0 && x <= nx - 1 && y >= 0 && y <= ny - 1)) return NaN;
  const i = Math.min(Math.floor(x), Math.max(0, nx - 2));
  const j = Math.min(Math.floor(y), Math.max(0, ny - 2));
  const corner = j * nx + i;
  const [east, north] = [nx > 1 ? 1 : 0, ny > 1 ? nx : 0];
  const south = mix(field[corner] ?? NaN, field[corner + east] ?? NaN, x - i);
  if (y === j) return south;
  return mix(south, mix(field[corner + north] ?? NaN, field[corner + north + east] ?? NaN, x - i), y - j);
}

/** A field at a time between two grids. */
export interface TimedPair {
  before: Grid;
  after: Grid;
  share: number; // weight of `after`, 0 to 1
}

/**
 * One variable at fixed places. Each grid is sampled once, and a moment between two grids is blended from their samples:
 * a playing clock passes many moments between the same two, and then the later grid becomes the earlier one.
 */
export class SampledPlaces {
  private samples = new Map<Grid, Float32Array>();

  constructor(private readonly variable: number, private readonly lons: Float64Array, private readonly lats: Float64Array) {}

  /** The values of a grid: one for each place, NaN where it has none. Kept for the two grids that were needed last. */
  private of(grid: Grid): Float32Array {
    const known = this.samples.get(grid);
    const values = known ?? new Float32Array(this.lons.length);
    if (!known) for (let i = 0; i < values.length; ++i) values[i] = sample(grid, this.variable, this.lons[i] ?? NaN, this.lats[i] ?? NaN);
    this.samples.delete(grid); // set again below as the newest
    this.samples.set(grid, values);
    for (const oldest of this.samples.keys()) if (this.samples.size > 2) this.samples.delete(oldest);
    return values;
  }

  /** The values at a moment, linear in time between its two grids; NaN where either has none. */
  at({ before, after, share }: TimedPair): Float32Array {
    const first = this.of(before);
    if (share === 0) return first;
    const second = this.of(after);
    const values = new Float32Array(first.length);
    for (let i = 0; i < values.length; ++i) values[i] = mix(first[i] ?? NaN, second[i] ?? NaN, share);
    return values;
  }
}
