import { unproject, type ProjectionCode } from './projections';

/**
 * Longitude and latitude of every node of a lattice in a projection, interpolated between exact positions `apart` nodes
 * from each other. This is a hundred times faster than projecting each node; away from the pole the error is far below
 * a node. `left` and `top` are the corner of the first node's cell, `resolution` the metres between nodes; columns run
 * right, rows down.
 */
export class PlaceLattice {
  private readonly columns: number;
  private readonly lons: Float64Array;
  private readonly lats: Float64Array;
  private base = 0;
  private down = 0;

  constructor(code: ProjectionCode, left: number, top: number, resolution: number, width: number, height: number, private readonly apart = 16) {
    this.columns = Math.ceil(width / apart) + 1;
    const rows = Math.ceil(height / apart) + 1;
    this.lons = new Float64Array(this.columns * rows);
    this.lats = new Float64Array(this.columns * rows);
    for (let j = 0; j < rows; ++j) {
      for (let i = 0; i < this.columns; ++i) {
        const [lon, lat] = unproject(code, [left + (i * apart + 0.5) * resolution, top - (j * apart + 0.5) * resolution]);
        this.lons[j * this.columns + i] = lon;
        this.lats[j * this.columns + i] = lat;
      }
    }
  }

  enterRow(y: number): void {
    this.base = Math.floor(y / this.apart) * this.columns;
    this.down = (y % this.apart) / this.apart;
  }

  lon(x: number): number {
    const at = this.base + Math.floor(x / this.apart);
    const right = (x % this.apart) / this.apart;
    const origin = this.lons[at] ?? NaN;
    const near = (value: number | undefined): number => {
      const step = (value ?? NaN) - origin;
      return step > 180 ? step - 360 : step < -180 ? step + 360 : step;
    };
    const upper = near(this.lons[at + 1]) * right;
    const lowerLeft = near(this.lons[at + this.columns]);
    const lower = lowerLeft + (near(this.lons[at + this.columns + 1]) - lowerLeft) * right;
    return origin + upper + (lower - upper) * this.down;
  }

  lat(x: number): number {
    const at = this.base + Math.floor(x / this.apart);
    const right = (x % this.apart) / this.apart;
    const mix = (from: number, to: number, share: number): number => from + (to - from) * share;
    const upper = mix(this.lats[at] ?? NaN, this.lats[at + 1] ?? NaN, right);
    const lower = mix(this.lats[at + this.columns] ?? NaN, this.lats[at + this.columns + 1] ?? NaN, right);
    return mix(upper, lower, this.down);
  }
}
