import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import LineString from 'ol/geom/LineString.js';
import Point from 'ol/geom/Point.js';
import Polygon from 'ol/geom/Polygon.js';
import VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Circle, Fill, RegularShape, Stroke, Style } from 'ol/style.js';
import type { Flight } from '../contract/simulation_types';
import type { Position } from '../contract/data_types';
import { circle } from '../geo/geodesic';
import { project, type ProjectionCode } from '../geo/projections';
import { time_ms } from '../model/clock';
import { isEcho, momentOf, sonarAt, sonarShown_s, stretchesOf } from '../model/plan/flight';
import { visible } from '../model/layers';
import { projection } from '../model/settings';
import { shownFlight } from '../model/plan/simulations';
import { palette, type Palette } from '../theme/palette';
import { toMap } from './projections';

const placed = (lon: number[], lat: number[]): Position[] => lon.map((x, i) => [x, lat[i] ?? NaN]);

/** The flight played back: true track, estimated track, manoeuvres, surfacings and contacts. */
export function flightLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new VectorLayer({ source, zIndex: 6 });
  effect(() => {
    const flight = shownFlight.value;
    source.clear(true);
    if (flight) source.addFeatures(featuresOf(flight, projection.value, palette.value));
  });
  effect(() => layer.setVisible(visible.value.plans));
  return layer;
}

function featuresOf(flight: Flight, code: ProjectionCode, colours: Palette): Feature[] {
  const { track, events } = flight;
  const flown = toMap(code, placed(track.lon, track.lat));
  const line = (places: Position[], ...strokes: Stroke[]): Feature => {
    const feature: Feature = new Feature(new LineString(places));
    feature.setStyle(strokes.map((stroke) => new Style({ stroke })));
    return feature;
  };
  const believed = line(
    toMap(code, placed(track.believed_lon, track.believed_lat)), new Stroke({ color: colours.label, width: 1.5, lineDash: [3, 4] }),
  );
  const asFlown = line(flown, new Stroke({ color: colours.casing, width: 4.5 }), new Stroke({ color: colours.ink, width: 2 }));
  const manoeuvres = stretchesOf(track.mode)
    .filter(({ mode }) => mode !== 'mission')
    .map(({ first, last }) => line(flown.slice(first, last + 2), new Stroke({ color: colours.danger, width: 4 })));
  const signs = events.flatMap(({ kind, lon, lat }) => {
    const style = kind === 'surfacing' ? surfacing(colours) : kind === 'contact' ? contact(colours) : undefined;
    if (!style) return [];
    const sign: Feature = new Feature(new Point(project(code, [lon, lat])));
    sign.setStyle(style);
    return [sign];
  });
  return [believed, asFlown, ...manoeuvres, ...signs];
}

const surfacing = ({ ink, casing }: Palette): Style[] => [
  new Style({ image: new Circle({ radius: 4.5, fill: new Fill({ color: casing }), stroke: new Stroke({ color: ink, width: 1.8 }) }) }),
];

const contact = ({ danger, casing }: Palette): Style[] =>
  [{ color: casing, width: 7 }, { color: danger, width: 3.5 }].map(
    (stroke) => new Style({ image: new RegularShape({ points: 4, radius: 11, radius2: 0, angle: Math.PI / 4, stroke: new Stroke(stroke) }) }),
  );

/**
 * The simulated vehicle at the clock's time, its estimated position with one standard deviation, and the distance of
 * the nearest sonar return.
 */
export function flownVehicleLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new VectorLayer({ source, zIndex: 9 });
  effect(() => {
    const code = projection.value;
    const colours = palette.value;
    const flight = shownFlight.value;
    const now = flight && momentOf(flight, time_ms.value);
    source.clear(true);
    if (!now) return;
    const ring = (centre: Position, radius_m: number, style: Style): void => {
      const feature = new Feature(new Polygon([toMap(code, circle(centre, radius_m))]));
      feature.setStyle(style);
      source.addFeature(feature);
    };
    ring(now.believed, Math.max(1, now.sigma_m), new Style({ stroke: new Stroke({ color: colours.label, width: 1.2, lineDash: [3, 3] }) }));
    const echo = sonarAt(flight, time_ms.value, sonarShown_s);
    if (echo && isEcho(echo.returns)) ring(now.place, echo.nearest_m, new Style({ stroke: new Stroke({ color: colours.danger, width: 1.5, lineDash: [2, 4] }) }));
    const evading = now.mode !== 'mission';
    const vehicle = new Feature(new Point(project(code, now.place)));
    vehicle.setStyle(
      new Style({
        image: new Circle({
          radius: 6.5, fill: new Fill({ color: evading ? colours.danger : now.atSurface ? colours.casing : colours.ink }),
          stroke: new Stroke({ color: now.atSurface && !evading ? colours.ink : colours.casing, width: 2 }),
        }),
      }),
    );
    source.addFeature(vehicle);
  });
  effect(() => layer.setVisible(visible.value.plans));
  return layer;
}
