import { signal } from '@preact/signals';

interface SeaIcePalette {
  veil: string; // colour laid over the map once for each step of concentration
  hatch: string;
  edge: string;
  figure: string;
  unknown: string; // hatching where the data have no value
}

/** Colours for painting on the map's canvases, which cannot read style sheets. */
export interface Palette {
  sea: string;
  depthTints: readonly [string, string, string, string, string]; // shallow to deep
  isobath: string;
  shallow: string;
  land: string;
  coast: string;
  graticule: string;
  label: string;
  halo: string;
  currents: readonly [string, string, string]; // slow to fast
  seaIce: SeaIcePalette;
  danger: string;
  dangerFill: string;
  caution: string;
  stale: string;
  berg: string;
  ink: string;
  casing: string;
  reach: string;
  reachFill: string;
  start: string;
  goal: string;
  plans: readonly [string, ...string[]]; // as --plan-0 and so on
}

export const light: Palette = {
  sea: '#f0f5f8',
  depthTints: ['#f0f8fb', '#ddecf4', '#c6ddeb', '#abcadf', '#8fb4d1'],
  isobath: '#7fa6c4',
  shallow: '#8a6100',
  land: '#e9e4d8',
  coast: '#6b6357',
  graticule: 'rgba(19, 35, 47, 0.22)',
  label: '#33495a',
  halo: 'rgba(255, 255, 255, 0.9)',
  currents: ['#3b6f8f', '#1d5277', '#0b2f4a'],
  seaIce: {
    veil: 'rgba(255, 255, 255, 0.26)', hatch: 'rgba(28, 66, 92, 0.42)', edge: '#1c425c', figure: '#1c425c', unknown: 'rgba(75, 96, 112, 0.28)',
  },
  danger: '#b3261e',
  dangerFill: 'rgba(179, 38, 30, 0.10)',
  caution: '#8a6100',
  stale: '#70777c',
  berg: '#ffffff',
  ink: '#13232f',
  casing: '#ffffff',
  reach: '#6a4c00',
  reachFill: 'rgba(138, 97, 0, 0.09)',
  start: '#117733',
  goal: '#13232f',
  plans: ['#b5400a', '#5b2a86', '#006b5b', '#8a1550', '#1a5fb4', '#6b5900', '#c4127f', '#3a6b00', '#703a1c', '#4d5866'],
};

export const dark: Palette = {
  sea: '#14222c',
  depthTints: ['#2b4a5c', '#243f50', '#1d3444', '#172a38', '#11202d'],
  isobath: '#3f6379',
  shallow: '#d9a441',
  land: '#3b3b36',
  coast: '#9a9384',
  graticule: 'rgba(214, 226, 234, 0.2)',
  label: '#b9c9d4',
  halo: 'rgba(9, 18, 25, 0.85)',
  currents: ['#6fa9c9', '#9cc9e2', '#d3ebf7'],
  seaIce: {
    veil: 'rgba(214, 232, 242, 0.10)', hatch: 'rgba(222, 238, 247, 0.38)', edge: '#dceaf2', figure: '#dceaf2', unknown: 'rgba(185, 201, 212, 0.22)',
  },
  danger: '#ff8a80',
  dangerFill: 'rgba(255, 138, 128, 0.12)',
  caution: '#e6b354',
  stale: '#8d979e',
  berg: '#e6f1f7',
  ink: '#dbe6ed',
  casing: '#0b151c',
  reach: '#e6b354',
  reachFill: 'rgba(230, 179, 84, 0.09)',
  start: '#6fd08c',
  goal: '#dbe6ed',
  plans: ['#ff9d6b', '#c9a6f2', '#5fd4c0', '#f58bb8', '#7db8ff', '#d8c34a', '#ff8fe0', '#a6d65c', '#d8a184', '#b9c3cf'],
};

/** The palette in use; the theme switch sets it. */
export const palette = signal<Palette>(light);

/** Upper ends of the depth tints in metres; the last tint has none. */
export const depthLimits_m = [50, 200, 500, 1000] as const;

/** Upper ends of the slow and the middle class of currents in m/s. */
export const currentLimits_m_s = [0.15, 0.4] as const;

/** Dash patterns of the plans in pixels, so that colour is not the only difference. */
const planDashes: readonly (readonly number[])[] = [[], [14, 7], [12, 6, 2, 6], [2, 7]];

/** Which of the colours a plan has. */
export const hueOf = (style: number): number => style % light.plans.length;

/** A colour comes again with another dash pattern: twenty plans differ. */
export const planDash = (style: number): number[] => [...(planDashes[(style + Math.floor(style / light.plans.length)) % 4] ?? [])];

export const planColour = ({ plans }: Palette, style: number): string => plans[hueOf(style)] ?? plans[0];

/** Dashes of the stretches below ice of any plan, and of the edges beside them. */
export const belowIceDash = [5, 5] as const;
export const tunnelDash = [10, 5] as const;

/** Marks of a square tile of hatching, as a path of SVG. */
export interface Hatch {
  tile_px: number;
  marks: string;
  width: number;
}

/**
 * The marks that each step of concentration adds: dots, slanting lines, more of them, crossing lines. Denser means more
 * ice, without colour.
 */
export const seaIceHatches: readonly [Hatch, Hatch, Hatch, Hatch] = [
  { tile_px: 12, marks: 'M3 9 h0.01 M9 3 h0.01', width: 2 },
  { tile_px: 12, marks: 'M-1 -1 L13 13 M11 -1 L13 1 M-1 11 L1 13', width: 1 },
  { tile_px: 12, marks: 'M5 -1 L13 7 M-1 5 L7 13', width: 1 },
  { tile_px: 12, marks: 'M13 -1 L-1 13 M1 -1 L-1 1 M13 11 L11 13', width: 1 },
];

/** The hatch where the data have no value: a dash, as in tables. */
export const unknownHatch: Hatch = { tile_px: 18, marks: 'M2 5 h5 M11 14 h5', width: 1 };

/** Dashes of the outlines of an ice chart. */
export const chartDash = [9, 3, 2, 3] as const;

/** Dashes of the line beyond which the vehicle may not surface. */
export const surfacingDash = [7, 4] as const;
