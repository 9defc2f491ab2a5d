import { effect } from '@preact/signals';
import ImageLayer from 'ol/layer/Image.js';
import ImageCanvas from 'ol/source/ImageCanvas.js';
import { sample, type Grid } from '../geo/grid';
import { PlaceLattice } from '../geo/place_lattice';
import type { ProjectionCode } from '../geo/projections';
import { bathymetry, coast } from '../model/field';
import { vehicles } from '../model/datasets';
import { draft } from '../model/setup/draft';
import { visible } from '../model/layers';
import { depthLimits_m, palette, type Palette } from '../theme/palette';
import { projection } from '../model/settings';

/** Depth tints with a thin line between them; hatched where the water is too shallow for the vehicle. */
export function bathymetryLayer(): ImageLayer<ImageCanvas> {
  const layer = new ImageLayer<ImageCanvas>({ zIndex: 0 });
  effect(() => {
    const grid = bathymetry.value;
    const code = projection.value;
    const paint = tinter(palette.value, coast.value.length === 0, shallowLimit_m());
    layer.setVisible(visible.value.bathymetry && grid !== undefined);
    if (!grid) return;
    layer.setSource(
      new ImageCanvas({
        projection: code,
        ratio: 1.3,
        canvasFunction: (extent, resolution, pixelRatio, size) =>
          painted(grid, code, [extent[0] ?? 0, extent[3] ?? 0], resolution / pixelRatio, [size[0] ?? 1, size[1] ?? 1], paint),
      }),
    );
  });
  return layer;
}

function shallowLimit_m(): number {
  const vehicle = vehicles.value.find(({ name }) => name === draft.value.vehicle) ?? vehicles.value[0];
  return vehicle?.minimum_working_depth_m ?? 0;
}

type Tinter = (depth_m: number, x: number, y: number) => { colour: number; tint: number };

/** RGBA as the 32-bit word of a little-endian canvas. */
function word(hex: string): number {
  const value = Number.parseInt(hex.slice(1), 16);
  return ((255 << 24) | ((value & 255) << 16) | (value & 0xff00) | (value >> 16)) >>> 0;
}

function tinter(colours: Palette, paintLand: boolean, shallow_m: number): Tinter {
  const tints = colours.depthTints.map(word);
  const [land, shallow] = [word(colours.land), word(colours.shallow)];
  return (depth_m, x, y) => {
    if (Number.isNaN(depth_m)) return { colour: 0, tint: -1 };
    if (depth_m <= 0) return { colour: paintLand ? land : (tints[0] ?? 0), tint: 9 };
    let tint = 0;
    while (tint < depthLimits_m.length && depth_m > (depthLimits_m[tint] ?? 0)) ++tint;
    const hatched = depth_m > 0 && depth_m < shallow_m && (x + y) % 9 === 0;
    return { colour: hatched ? shallow : (tints[tint] ?? 0), tint };
  };
}

function painted(
  grid: Grid, code: ProjectionCode, [left, top]: [number, number], resolution: number, [width, height]: [number, number], tint: Tinter,
): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(width));
  canvas.height = Math.max(1, Math.round(height));
  const context = canvas.getContext('2d');
  if (!context) return canvas;
  const image = context.createImageData(canvas.width, canvas.height);
  const pixels = new Uint32Array(image.data.buffer);
  const isobath = word(palette.peek().isobath);
  const above = new Int8Array(canvas.width).fill(-1);

  const places = new PlaceLattice(code, left, top, resolution, canvas.width, canvas.height);
  for (let y = 0; y < canvas.height; ++y) {
    let before = -1;
    places.enterRow(y);
    for (let x = 0; x < canvas.width; ++x) {
      const { colour, tint: here } = tint(sample(grid, 0, places.lon(x), places.lat(x)), x, y);
      const edge = isContour(here, before) || isContour(here, above[x] ?? -1);
      pixels[y * canvas.width + x] = edge ? isobath : colour;
      before = here;
      above[x] = here;
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

const isContour = (here: number, other: number): boolean => here !== other && here >= 0 && other >= 0 && here < 9 && other < 9;
