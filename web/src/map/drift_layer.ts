import { computed, effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import type Geometry from 'ol/geom/Geometry.js';
import LineString from 'ol/geom/LineString.js';
import MultiPoint from 'ol/geom/MultiPoint.js';
import Point from 'ol/geom/Point.js';
import Polygon from 'ol/geom/Polygon.js';
import VectorImageLayer from 'ol/layer/VectorImage.js';
import VectorSource from 'ol/source/Vector.js';
import { Circle, Fill, RegularShape, Stroke, Style } from 'ol/style.js';
import { circle } from '../geo/geodesic';
import { project } from '../geo/projections';
import { time_ms } from '../model/clock';
import { drifts, expectedAt, ticksOf, wayOf } from '../model/drift';
import { crowd, keepOut_m } from '../model/icebergs';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { view } from '../model/view';
import { palette } from '../theme/palette';
import { toMap } from './projections';

/** Farther out than this many metres in a pixel, rings and ticks would hide the map. */
const rings_m = 150;
const ticks_m = 60;

/** And the lines themselves, where bergs lie close together. */
const lines_m = 300;

/** Rings of many bergs overlap: each lets the plans and the others shine through. */
const half = '80';

/**
 * Dashes along hundreds of long lines take a processor without a graphics card a tenth of a second, so what does not change is
 * painted once as a picture this much wider and higher than the map, not again in each frame.
 */
const painted = 1.2;

const isShown = (): boolean => visible.value.drift && visible.value.icebergs;
const ringsAreShown = computed(() => (view.value?.metresPerPixel ?? Infinity) < rings_m);

/** Where each berg is expected to go: a thin line with a tick every six hours. */
export function driftLayer(): VectorImageLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new VectorImageLayer({ source, zIndex: 5, imageRatio: painted });
  effect(() => {
    const code = projection.value;
    source.clear(true);
    if (drifts.value.length > crowd) return;
    source.addFeatures(
      drifts.value.flatMap((drift) => {
        const way = wayOf(drift);
        return way.length < 2 ? [] : [new Feature(new LineString(toMap(code, way))), new Feature(new MultiPoint(toMap(code, ticksOf(drift))))];
      }),
    );
  });
  effect(() => {
    const { reach } = palette.value;
    const line = new Style({ stroke: new Stroke({ color: reach, width: 1 }) });
    const tick = new Style({ image: new Circle({ radius: 1.8, fill: new Fill({ color: reach }) }) });
    layer.setStyle((feature, resolution) => {
      const isLine = feature.getGeometry()?.getType() === 'LineString';
      return resolution < (isLine ? lines_m : ticks_m) ? (isLine ? line : tick) : undefined;
    });
  });
  effect(() => layer.setVisible(isShown()));
  return layer;
}

/** Where each berg is expected at the clock's time, in the ring that plans keep out of: it grows with the error of the position. */
export function ghostLayer(): VectorImageLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new VectorImageLayer({ source, zIndex: 5, imageRatio: painted });
  effect(() => {
    if (!isShown() || drifts.value.length > crowd) {
      source.clear(true);
      return;
    }
    const code = projection.value;
    const minute = Math.round(time_ms.value / 60_000) * 60_000;
    const ghosts = drifts.value.flatMap((drift) => {
      const expected = expectedAt(drift, minute);
      if (!expected || minute <= Date.parse(drift.observed)) return [];
      const ghost = new Feature<Geometry>(new Point(project(code, expected.place)));
      if (!ringsAreShown.value) return [ghost];
      return [new Feature<Geometry>(new Polygon([toMap(code, circle(expected.place, keepOut_m(drift.safe_length_m, expected.error_m)))])), ghost];
    });
    source.clear(true);
    source.addFeatures(ghosts);
  });
  effect(() => {
    const { reach } = palette.value;
    const ring = new Style({ stroke: new Stroke({ color: reach + half, width: 1, lineDash: [2, 5] }) });
    const ghost = new Style({ image: new RegularShape({ points: 3, radius: 6, stroke: new Stroke({ color: reach, width: 1.4, lineDash: [3, 2] }) }) });
    layer.setStyle((feature) => (feature.getGeometry()?.getType() === 'Point' ? ghost : ring));
  });
  return layer;
}
