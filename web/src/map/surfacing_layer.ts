import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import type Geometry from 'ol/geom/Geometry.js';
import LineString from 'ol/geom/LineString.js';
import Point from 'ol/geom/Point.js';
import VectorSource from 'ol/source/Vector.js';
import { Circle, Fill, Stroke, Style, Text } from 'ol/style.js';
import type { Position } from '../contract/data_types';
import type { Plan } from '../contract/types';
import { densify } from '../geo/geodesic';
import { project, type ProjectionCode } from '../geo/projections';
import { visible } from '../model/layers';
import { selectedShown, selectedWaypoint } from '../model/plan/plans';
import { openEdit } from '../model/plan/route_edit';
import { projection } from '../model/settings';
import { palette, type Palette } from '../theme/palette';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/** Shows features of the selected plan, or of its edit, with the layer "surfacings". */
function layerOfPlan(zIndex: number, featuresOf: (plan: Plan, code: ProjectionCode, colours: Palette) => Feature[]): StillLayer {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex });
  effect(() => {
    const plan = openEdit.value?.figures ?? selectedShown.value?.plan;
    source.clear(true);
    if (plan) source.addFeatures(featuresOf(plan, projection.value, palette.value));
  });
  effect(() => layer.setVisible(visible.value.plans && visible.value.surfacings));
  return layer;
}

/** Escape routes to open water, below the plans, whose legs some of them follow; that of the chosen waypoint is thicker. */
export const escapeLayer = (): StillLayer =>
  layerOfPlan(5.5, ({ surfacing }, code, colours) => {
    const chosen = selectedWaypoint.value;
    const features: Feature[] = [];
    for (const { waypoint, way, time_s } of surfacing?.escapes ?? []) {
      const end = way.at(-1);
      if (time_s === 0 || !end) continue; // the vehicle may surface there at once
      const line = new Feature<Geometry>(new LineString(toMap(code, densify(way, 2000))));
      line.setStyle(escapeStyles(waypoint === chosen, colours));
      features.push(line);
    }
    return features;
  });

/** Planned surfacings, and where escape routes end. */
export const surfacingLayer = (): StillLayer =>
  layerOfPlan(7, ({ surfacing }, code, colours) => {
    const mark = (place: Position, style: Style): Feature => {
      const feature = new Feature<Geometry>(new Point(project(code, place)));
      feature.setStyle(style);
      return feature;
    };
    const refuge = new Style({ image: new Circle({ radius: 4, fill: new Fill({ color: colours.casing }), stroke: new Stroke({ color: colours.start, width: 2 }) }) });
    const planned = new Style({
      image: new Circle({ radius: 8, fill: new Fill({ color: colours.start }), stroke: new Stroke({ color: colours.casing, width: 2 }) }),
      text: new Text({ text: '↑', font: '700 13px system-ui, sans-serif', fill: new Fill({ color: colours.casing }) }),
    });
    const ends = (surfacing?.escapes ?? []).flatMap(({ way, time_s }) => (time_s === 0 ? [] : way.slice(-1)));
    return [...ends.map((place) => mark(place, refuge)), ...(surfacing?.planned ?? []).map(({ lon, lat }) => mark([lon, lat], planned))];
  });

function escapeStyles(chosen: boolean, colours: Palette): Style[] {
  const width = chosen ? 2.4 : 1.2;
  return [
    new Style({ stroke: new Stroke({ color: colours.casing, width: width + 2 }) }),
    new Style({ stroke: new Stroke({ color: colours.start, width, lineDash: [1, 4] }) }),
  ];
}
