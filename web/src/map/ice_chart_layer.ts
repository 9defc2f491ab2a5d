import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import Polygon from 'ol/geom/Polygon.js';
import type VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Fill, Stroke, Style, Text } from 'ol/style.js';
import { drawnChart, iceChart, shortTotal } from '../model/ice/ice_chart';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { chartDash, palette } from '../theme/palette';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/** The polygons of the ice chart in outline, each with its tenths where there is room; the probe shows the whole egg. */
export function iceChartLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 1 });
  effect(() => {
    const code = projection.value;
    const { seaIce, halo } = palette.value;
    const features = iceChart.value?.features ?? [];
    const lines = [
      new Style({ stroke: new Stroke({ color: halo, width: 3 }) }),
      new Style({ stroke: new Stroke({ color: seaIce.edge, width: 1.3, lineDash: [...chartDash] }) }),
    ];
    source.clear(true);
    source.addFeatures(
      features.map(({ geometry, properties }) => {
        const feature = new Feature(new Polygon(geometry.coordinates.map((ring) => toMap(code, ring))));
        const tenths = shortTotal(properties);
        const label = new Text({
          text: `${tenths}/10`, font: 'italic 600 12px system-ui, sans-serif', fill: new Fill({ color: seaIce.edge }), stroke: new Stroke({ color: halo, width: 3.5 }),
        });
        feature.setStyle(tenths ? [...lines, new Style({ text: label })] : lines);
        return feature;
      }),
    );
  });
  effect(() => layer.setVisible(visible.value.iceChart && drawnChart.value !== undefined));
  return layer;
}
