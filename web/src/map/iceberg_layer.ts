import { computed, effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import Point from 'ol/geom/Point.js';
import Polygon from 'ol/geom/Polygon.js';
import type VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Fill, RegularShape, Stroke, Style, Text } from 'ol/style.js';
import type { IcebergFeature, IcebergProperties } from '../contract/data_types';
import { circle } from '../geo/geodesic';
import { project } from '../geo/projections';
import { time_ms } from '../model/clock';
import { icebergs } from '../model/field';
import { icebergChoice } from '../model/setup/iceberg_choice';
import { crowd, keepOutRadii_m, lookOf, symbolSize_px, type Look } from '../model/ice/icebergs';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { sighting_days } from '../model/setup/sighting_age';
import { palette, type Palette } from '../theme/palette';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/** Keep-out circles: a solid one around a known position, a dashed one with the position error added. */
export function keepOutLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 5 });
  effect(() => {
    const code = projection.value;
    const ringed = icebergs.value.filter((berg) => icebergs.value.length <= crowd || symbolSize_px(berg.properties.size) >= 6);
    source.clear(true);
    source.addFeatures(
      ringed.flatMap((berg) => {
        const { kept_m, uncertain_m } = keepOutRadii_m(berg.properties);
        const ring = (radius_m: number, kind: string): Feature<Polygon> => {
          const feature = new Feature(new Polygon([toMap(code, circle(berg.geometry.coordinates, radius_m))]));
          feature.set('kind', kind);
          return feature;
        };
        return uncertain_m > kept_m ? [ring(uncertain_m, 'uncertain'), ring(kept_m, 'kept')] : [ring(kept_m, 'kept')];
      }),
    );
  });
  effect(() => {
    const { danger, dangerFill } = palette.value;
    const kept = new Style({ fill: new Fill({ color: dangerFill }), stroke: new Stroke({ color: danger, width: 1.5 }) });
    const uncertain = new Style({ stroke: new Stroke({ color: danger, width: 1.2, lineDash: [5, 5] }) });
    layer.setStyle((feature) => (feature.get('kind') === 'kept' ? kept : uncertain));
  });
  effect(() => layer.setVisible(visible.value.keepOut && visible.value.icebergs));
  return layer;
}

/** A triangle for each berg, its size by size class; paler the older the sighting is, and grey when it is a day old. */
export function icebergLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 7 });
  const features = new Map<IcebergFeature, Feature<Point>>();
  effect(() => {
    const code = projection.value;
    features.clear();
    for (const berg of icebergs.value) {
      const feature = new Feature(new Point(project(code, berg.geometry.coordinates)));
      feature.set('berg', berg);
      features.set(berg, feature);
    }
    source.clear(true);
    source.addFeatures([...features.values()]);
  });
  const hour_ms = computed(() => Math.floor(time_ms.value / 3_600_000) * 3_600_000);
  const lookNow = (berg: IcebergFeature): Look => lookOf(berg.properties, hour_ms.value, icebergChoice.value?.max_sighting_age_days ?? sighting_days);
  const observed = computed(() => [...new Map(icebergs.value.map((berg) => [berg.properties.observed, berg])).values()]); // one berg for each time
  const looks = computed(() => JSON.stringify(observed.value.map(lookNow))); // a text, equal in most hours, so that new symbols are rare
  effect(() => {
    const [colours] = [palette.value, looks.value]; // new symbols when either changes
    const symbols = new Map<string, RegularShape>();
    layer.setStyle((feature, resolution) => {
      const berg = feature.get('berg') as IcebergFeature;
      const { properties } = berg;
      const look = lookNow(berg);
      const key = `${properties.size} ${look.stale} ${look.strength}`;
      const image = symbols.get(key) ?? symbolOf(properties, look, colours);
      symbols.set(key, image);
      return new Style({ image, ...(resolution < 120 ? { text: nameOf(properties, colours) } : {}) });
    });
  });
  effect(() => layer.setVisible(visible.value.icebergs));
  return layer;
}

function symbolOf({ size }: IcebergProperties, { stale, strength }: Look, colours: Palette): RegularShape {
  const symbol = new RegularShape({
    points: size === 'radar_target' || size === 'unknown' ? 4 : 3,
    radius: symbolSize_px(size),
    fill: new Fill({ color: colours.berg }),
    stroke: new Stroke({ color: stale ? colours.stale : colours.ink, width: 1.6 }),
  });
  symbol.setOpacity(strength);
  return symbol;
}

const nameOf = ({ berg_id, size }: IcebergProperties, colours: Palette): Text =>
  new Text({
    text: berg_id,
    offsetY: -symbolSize_px(size) - 8,
    font: '11px system-ui, sans-serif',
    fill: new Fill({ color: colours.label }),
    stroke: new Stroke({ color: colours.halo, width: 3 }),
  });
