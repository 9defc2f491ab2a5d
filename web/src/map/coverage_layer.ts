import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import Point from 'ol/geom/Point.js';
import Polygon from 'ol/geom/Polygon.js';
import type VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Fill, Stroke, Style, Text } from 'ol/style.js';
import type { Box } from '../contract/data_types';
import { borderOf, width_deg } from '../geo/boxes';
import { wrapLongitude } from '../geo/geodesic';
import { project, projections } from '../geo/projections';
import { coveredDatasets } from '../model/coverage';
import { projection } from '../model/settings';
import { palette } from '../theme/palette';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/** Southern limit on polar maps, which are distorted further south; no mission goes there. */
const southernmost_deg = 35;

/** Borders of chosen datasets, with their names. */
export function coverageLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 4 });
  effect(() => {
    const code = projection.value;
    const { reach, reachFill, halo } = palette.value;
    source.clear(true);
    for (const { name, bbox } of coveredDatasets.value) {
      const box = withinMap(bbox, projections[code].polar);
      if (!box) continue;
      const area = new Feature(new Polygon([toMap(code, borderOf(box))]));
      area.setStyle(new Style({ fill: new Fill({ color: reachFill }), stroke: new Stroke({ color: reach, width: 2, lineDash: [8, 4] }) }));
      const middle = wrapLongitude(box[0] + width_deg(box) / 2);
      const label = new Feature(new Point(project(code, [middle, box[3]])));
      label.setStyle(
        new Style({
          text: new Text({
            text: name, offsetY: -9, font: '600 12px system-ui, sans-serif', fill: new Fill({ color: reach }), stroke: new Stroke({ color: halo, width: 3.5 }),
          }),
        }),
      );
      source.addFeatures([area, label]);
    }
  });
  return layer;
}

function withinMap([west, south, east, north]: Box, polar: boolean): Box | undefined {
  const southern = polar ? southernmost_deg : -84;
  if (north <= southern) return undefined;
  return [west, Math.max(south, southern), east, polar ? north : Math.min(north, 84)];
}
