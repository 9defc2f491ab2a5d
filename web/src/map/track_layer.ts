import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import LineString from 'ol/geom/LineString.js';
import Point from 'ol/geom/Point.js';
import VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Fill, RegularShape, Stroke, Style } from 'ol/style.js';
import type { GliderTrackFeature } from '../contract/data_types';
import { project, type ProjectionCode } from '../geo/projections';
import { rotateToView } from '../geo/vectors';
import { time_ms } from '../model/clock';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { gliderTracks, placeAt, placesOf } from '../model/tracks';
import { palette, type Palette } from '../theme/palette';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/** Length of an arrow in pixels per m/s, and the largest number of arrows of a track. */
const px_per_m_s = 90;
const most_arrows = 150;

/** Tracks of gliders with their depth-averaged currents. */
export function trackLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 5 });
  effect(() => {
    const [code, colours] = [projection.value, palette.value];
    source.clear(true);
    source.addFeatures(gliderTracks.value.flatMap((track) => [wayOf(track, code, colours), ...arrowsOf(track, code, colours)]));
  });
  effect(() => layer.setVisible(visible.value.tracks));
  return layer;
}

function wayOf(track: GliderTrackFeature, code: ProjectionCode, { casing, label }: Palette): Feature {
  const feature: Feature = new Feature(new LineString(toMap(code, placesOf(track))));
  feature.set('track', track);
  feature.setStyle([{ color: casing, width: 4 }, { color: label, width: 1.8, lineDash: [1, 4] }].map((stroke) => new Style({ stroke: new Stroke(stroke) })));
  return feature;
}

function arrowsOf({ properties: { current_frame, currents } }: GliderTrackFeature, code: ProjectionCode, colours: Palette): Feature[] {
  if (current_frame === 'vehicle') return [];
  const every = Math.ceil(currents.length / most_arrows);
  const stroke = new Stroke({ color: colours.currents[2], width: 1.8 });
  const head = new Fill({ color: colours.currents[2] });
  return currents.filter((_, i) => i % every === 0).map(({ lon, lat, east_m_s, north_m_s }) => {
    const [x, y] = project(code, [lon, lat]);
    const [dx, dy] = rotateToView(code, [lon, lat], east_m_s, north_m_s);
    const feature: Feature = new Feature(new Point([x, y]));
    feature.setStyle((_, resolution) => {
      const tip = [x + dx * px_per_m_s * resolution, y + dy * px_per_m_s * resolution];
      return [
        new Style({ geometry: new LineString([[x, y], tip]), stroke }),
        new Style({ geometry: new Point(tip), image: new RegularShape({ points: 3, radius: 4.5, rotation: Math.PI / 2 - Math.atan2(dy, dx), rotateWithView: true, fill: head }) }),
      ];
    });
    return feature;
  });
}

/** Where each glider was at the clock's time. */
export function trackedGliderLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new VectorLayer({ source, zIndex: 8 });
  effect(() => {
    const [code, now_ms, { casing, ink }] = [projection.value, time_ms.value, palette.value];
    const style = new Style({ image: new RegularShape({ points: 4, radius: 7, fill: new Fill({ color: casing }), stroke: new Stroke({ color: ink, width: 2 }) }) });
    source.clear(true);
    for (const track of gliderTracks.value) {
      const place = placeAt(track, now_ms);
      if (!place) continue;
      const feature: Feature = new Feature(new Point(project(code, place)));
      feature.set('track', track);
      feature.setStyle(style);
      source.addFeature(feature);
    }
  });
  effect(() => layer.setVisible(visible.value.tracks));
  return layer;
}
