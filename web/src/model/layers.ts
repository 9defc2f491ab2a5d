import { signal } from '@preact/signals';

/** What the map can show, in the order of the layers panel (uppermost first). */
export const layerTitles = {
  plans: 'Plans',
  surfacings: 'Surfacings',
  areas: 'Areas',
  tracks: 'Glider tracks',
  reach: 'Reach',
  icebergs: 'Icebergs',
  keepOut: 'Keep-out circles',
  drift: 'Iceberg drift',
  graticule: 'Graticule',
  coast: 'Coast',
  currents: 'Currents',
  iceChart: 'Ice chart',
  seaIce: 'Sea ice',
  bathymetry: 'Depth tints',
} as const;

export type LayerName = keyof typeof layerTitles;
export const layerNames = Object.keys(layerTitles) as LayerName[];

export const visible = signal<Record<LayerName, boolean>>({
  plans: true, surfacings: true, areas: true, tracks: true, reach: true, icebergs: true, keepOut: true, drift: true, graticule: true, coast: true, currents: true, iceChart: true, seaIce: true, bathymetry: true,
});

export function toggleLayer(name: LayerName): void {
  visible.value = { ...visible.value, [name]: !visible.value[name] };
}
