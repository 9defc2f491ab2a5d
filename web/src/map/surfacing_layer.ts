import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import type Geometry from 'ol/geom/Geometry.js';
import LineString from 'ol/geom/LineString.js';
import Point from 'ol/geom/Point.js';
import type VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Circle, Fill, Stroke, Style, Text } from 'ol/style.js';
import type { Surfacing } from '../contract/types';
import { densify } from '../geo/geodesic';
import { project } from '../geo/projections';
import { visible } from '../model/layers';
import { selectedShown, selectedWaypoint } from '../model/plan/plans';
import { openEdit } from '../model/plan/route_edit';
import { projection } from '../model/settings';
import { palette, type Palette } from '../theme/palette';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/**
 * Planned surfacings of the selected plan, and its escape routes to open water; that of the chosen waypoint is thicker.
 */
export function surfacingLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 7 });
  effect(() => {
    const code = projection.value;
    const colours = palette.value;
    const plan = openEdit.value?.figures ?? selectedShown.value?.plan;
    const chosen = selectedWaypoint.value;
    source.clear(true);
    for (const { waypoint, way, time_s } of plan?.surfacing?.escapes ?? []) {
      const end = way.at(-1);
      if (time_s === 0 || !end) continue; // the vehicle may surface there at once
      const line = new Feature<Geometry>(new LineString(toMap(code, densify(way, 2000))));
      line.setStyle(escapeStyles(waypoint === chosen, colours));
      const refuge = new Feature<Geometry>(new Point(project(code, end)));
      refuge.setStyle(new Style({ image: new Circle({ radius: 4, fill: new Fill({ color: colours.casing }), stroke: new Stroke({ color: colours.start, width: 2 }) }) }));
      source.addFeatures([line, refuge]);
    }
    for (const surfacing of plan?.surfacing?.planned ?? []) source.addFeature(plannedSurfacing(surfacing));

    function plannedSurfacing({ lon, lat }: Surfacing['planned'][number]): Feature {
      const mark = new Feature<Geometry>(new Point(project(code, [lon, lat])));
      mark.setStyle(
        new Style({
          image: new Circle({ radius: 8, fill: new Fill({ color: colours.start }), stroke: new Stroke({ color: colours.casing, width: 2 }) }),
          text: new Text({ text: '↑', font: '700 13px system-ui, sans-serif', fill: new Fill({ color: colours.casing }) }),
        }),
      );
      return mark;
    }
  });
  effect(() => layer.setVisible(visible.value.plans && visible.value.surfacings));
  return layer;
}

function escapeStyles(chosen: boolean, colours: Palette): Style[] {
  const width = chosen ? 2.4 : 1.2;
  return [
    new Style({ stroke: new Stroke({ color: colours.casing, width: width + 2 }) }),
    new Style({ stroke: new Stroke({ color: colours.start, width, lineDash: [1, 4] }) }),
  ];
}
