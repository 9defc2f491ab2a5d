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
import { driftLineOf, drifts, expectedAt, plainLineOf, ticksOf } from '../model/drift';
import { crowd, keepOut_m } from '../model/icebergs';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { view } from '../model/view';
import { palette } from '../theme/palette';
import { toMap } from './projections';

/** Farther out than this many metres in a pixel, rings would hide the map; so would ticks, and lines that swing with the tide. */
const rings_m = 150;
const tides_m = 60;

/** And lines of any kind, where bergs lie close together. */
const lines_m = 300;

/** Rings and lines of many bergs overlap: each lets the plans and the others shine through. */
const most = 'b0';
const half = '80';

/**
 * Dashes along hundreds of long lines take a processor without a graphics card a tenth of a second, so what does not change is
 * painted once as a picture this much wider and higher than the map, not again in each frame.
 */
const painted = 1.2;

/** What a line of drift is made of, at scales small and large. */
type Detail = 'plain' | 'tidal' | 'ticks';

const isShown = (): boolean => visible.value.drift && visible.value.icebergs;
const ringsAreShown = computed(() => (view.value?.metresPerPixel ?? Infinity) < rings_m);

/** Where each berg is expected to go: a thin line with a tick every six hours; seen from afar, a pale one without the tides. */
export function driftLayer(): VectorImageLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new VectorImageLayer({ source, zIndex: 5, imageRatio: painted });
  effect(() => {
    const code = projection.value;
    source.clear(true);
    if (drifts.value.length > crowd) return;
    source.addFeatures(
      drifts.value.flatMap((drift) => {
        const line = driftLineOf(drift);
        if (line.length < 2) return [];
        const drawn: [Detail, Geometry][] = [
          ['plain', new LineString(toMap(code, plainLineOf(drift)))], ['tidal', new LineString(toMap(code, line))], ['ticks', new MultiPoint(toMap(code, ticksOf(drift)))],
        ];
        return drawn.map(([detail, geometry]) => new Feature({ detail, geometry }));
      }),
    );
  });
  effect(() => {
    const { reach } = palette.value;
    const styles: Record<Detail, Style> = {
      plain: new Style({ stroke: new Stroke({ color: reach + half, width: 1 }) }),
      tidal: new Style({ stroke: new Stroke({ color: reach, width: 1 }) }),
      ticks: new Style({ image: new Circle({ radius: 1.8, fill: new Fill({ color: reach }) }) }),
    };
    layer.setStyle((feature, resolution) => {
      const detail = feature.get('detail') as Detail;
      const isDrawn = detail === 'plain' ? resolution >= tides_m && resolution < lines_m : resolution < tides_m;
      return isDrawn ? styles[detail] : undefined;
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
    const { reach, berg } = palette.value;
    const ring = new Style({ stroke: new Stroke({ color: reach + most, width: 1.2, lineDash: [4, 4] }) });
    const ghost = new Style({
      image: new RegularShape({ points: 3, radius: 7, fill: new Fill({ color: berg }), stroke: new Stroke({ color: reach, width: 1.6, lineDash: [4, 2] }) }),
    });
    layer.setStyle((feature) => (feature.getGeometry()?.getType() === 'Point' ? ghost : ring));
  });
  return layer;
}
