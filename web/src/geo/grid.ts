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

/** Column and row of a place as fractions, or undefined outside the grid. */
function cellOf(grid: Grid, lon: number, lat: number): [x: number, y: number] | undefined {
  const y = (lat - grid.south_deg) / grid.dy_deg;
  let x = (lon - grid.west_deg) / grid.dx_deg;
  const turn = 360 / grid.dx_deg;
  if (x < 0) x += turn;
  else if (x > grid.nx - 1 && x - turn >= 0) x -= turn;
  if (!(x >= 0 && x <= grid.nx - 1 && y >= 0 && y <= grid.ny - 1)) return undefined;
  return [x, y];
}

/** Bilinear value of one variable; NaN outside the grid or when any of the four corners is missing. */
export function sample(grid: Grid, variable: number, lon: number, lat: number): number {
  const cell = cellOf(grid, lon, lat);
  const field = grid.values[variable];
  if (!cell || !field) return NaN;
  const i = Math.min(Math.floor(cell[0]), Math.max(0, grid.nx - 2));
  const j = Math.min(Math.floor(cell[1]), Math.max(0, grid.ny - 2));
  const fx = cell[0] - i;
  const fy = cell[1] - j;
  const at = (di: number, dj: number): number => field[Math.min(j + dj, grid.ny - 1) * grid.nx + Math.min(i + di, grid.nx - 1)] ?? NaN;
  const south = fx === 0 ? at(0, 0) : at(0, 0) * (1 - fx) + at(1, 0) * fx;
  if (fy === 0) return south;
  const north = fx === 0 ? at(0, 1) : at(0, 1) * (1 - fx) + at(1, 1) * fx;
  return south * (1 - fy) + north * fy;
}

/** A field at a time between two grids. */
export interface TimedPair {
  before: Grid;
  after: Grid;
  share: number; // weight of `after`, 0 to 1
}

/** Linear in time between two grids. */
export function samplePair(pair: TimedPair, variable: number, lon: number, lat: number): number {
  const before = sample(pair.before, variable, lon, lat);
  if (pair.share === 0) return before;
  return before * (1 - pair.share) + sample(pair.after, variable, lon, lat) * pair.share;
}
