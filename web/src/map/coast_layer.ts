import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import Polygon from 'ol/geom/Polygon.js';
import VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Fill, Stroke, Style } from 'ol/style.js';
import type { CoastFeature, Position } from '../api/data_types';
import { clipSouth } from '../geo/boxes';
import { mercatorNorthLimit_deg, polarSouthLimit_deg, projections, type ProjectionCode } from '../geo/projections';
import { coast } from '../model/field';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { palette } from '../theme/palette';
import { toMap } from './projections';

/** Land. It lies over the currents, so that no arrow is seen ashore. */
export function coastLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new VectorLayer({ source, zIndex: 2, updateWhileInteracting: true, updateWhileAnimating: true });
  effect(() => {
    source.clear(true);
    source.addFeatures(coast.value.flatMap((feature) => landOf(feature, projection.value)));
  });
  effect(() => {
    const { land, coast: line } = palette.value;
    layer.setStyle(new Style({ fill: new Fill({ color: land }), stroke: new Stroke({ color: line, width: 1 }) }));
  });
  effect(() => layer.setVisible(visible.value.coast));
  return layer;
}

function landOf({ geometry }: CoastFeature, code: ProjectionCode): Feature<Polygon>[] {
  const polygons = geometry.type === 'Polygon' ? [geometry.coordinates] : geometry.coordinates;
  return polygons.flatMap((rings) => {
    const drawn = rings.map((ring) => toMap(code, clipped(ring, code))).filter((ring) => ring.length > 3);
    return drawn.length > 0 ? [new Feature(new Polygon(drawn))] : [];
  });
}

function clipped(ring: Position[], code: ProjectionCode): Position[] {
  if (projections[code].polar) return clipSouth(ring, polarSouthLimit_deg);
  return ring.map(([lon, lat]) => [lon, Math.min(lat, mercatorNorthLimit_deg)]);
}
