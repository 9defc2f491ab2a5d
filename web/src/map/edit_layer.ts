import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import LineString from 'ol/geom/LineString.js';
import Point from 'ol/geom/Point.js';
import { Translate } from 'ol/interaction.js';
import VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Circle, Fill, Stroke, Style, Text } from 'ol/style.js';
import type { Position } from '../contract/data_types';
import { densify } from '../geo/geodesic';
import { project, unproject } from '../geo/projections';
import { selectedWaypoint, shownPlans, waypointLabel } from '../model/plan/plans';
import { halfway, insertWaypoint, moveWaypoint, openEdit, type RouteEdit } from '../model/plan/route_edit';
import { projection } from '../model/settings';
import { palette, planColour, type Palette } from '../theme/palette';
import { toMap } from './projections';

/** Handles are drawn 16 px wide and can be grabbed within 22 px of their centre. */
const handleRadius_px = 8;
const hold_px = 14;

/**
 * The edited route with a handle on each waypoint and a small one in the middle of each leg, which becomes a new
 * waypoint when it is dragged. The line follows the pointer; the model changes when it is released.
 */
export function editLayer(): { layer: VectorLayer<VectorSource>; drag: Translate } {
  const source = new VectorSource();
  const layer = new VectorLayer({ source, zIndex: 11, updateWhileInteracting: true, updateWhileAnimating: true });
  let line = new Feature<LineString>();

  effect(() => {
    const edit = openEdit.value;
    const code = projection.value;
    const chosen = selectedWaypoint.value;
    const colours = palette.value;
    source.clear(true);
    if (!edit) return;
    const route = edit.route;
    const colour = colourOf(edit, colours);
    line = new Feature(new LineString(toMap(code, densify(route, 2000))));
    line.setStyle(lineStyles(edit, colour, colours));
    source.addFeature(line);
    route.slice(1).forEach((to, i) => {
      const from = route[i];
      if (!from) return;
      const middle = new Feature(new Point(project(code, halfway(from, to))));
      middle.set('insert', i + 1);
      middle.setStyle(middleStyle(colour, colours));
      source.addFeature(middle);
    });
    route.forEach((place, i) => {
      const handle = new Feature(new Point(project(code, place)));
      handle.set('handle', i);
      handle.setStyle(handleStyle(i, i === chosen, colour, colours));
      source.addFeature(handle);
    });
  });

  const isHandle = (feature: Feature): boolean => feature.get('handle') !== undefined || feature.get('insert') !== undefined;
  const drag = new Translate({ layers: [layer], hitTolerance: hold_px, filter: (feature) => isHandle(feature) });
  drag.on('translating', ({ features }) => {
    const route = routeWith(features.item(0));
    if (route) line.getGeometry()?.setCoordinates(toMap(projection.peek(), densify(route, 2000)));
  });
  drag.on('translateend', ({ features }) => {
    const feature = features.item(0);
    const place = placeOf(feature);
    const handle = feature.get('handle') as number | undefined;
    const before = feature.get('insert') as number | undefined;
    if (handle !== undefined) {
      selectedWaypoint.value = handle;
      moveWaypoint(handle, place);
    } else if (before !== undefined) insertWaypoint(before, place);
  });
  effect(() => drag.setActive(openEdit.value !== undefined));
  return { layer, drag };
}

function placeOf(feature: Feature): Position {
  const [x = 0, y = 0] = (feature.getGeometry() as Point).getCoordinates();
  return unproject(projection.peek(), [x, y]);
}

/** The route if the dragged handle were released now. */
function routeWith(feature: Feature): Position[] | undefined {
  const route = openEdit.peek()?.route;
  const handle = feature.get('handle') as number | undefined;
  const before = feature.get('insert') as number | undefined;
  if (handle !== undefined) return route?.map((place, i) => (i === handle ? placeOf(feature) : place));
  return before === undefined || !route ? route : [...route.slice(0, before), placeOf(feature), ...route.slice(before)];
}

function colourOf(edit: RouteEdit, colours: Palette): string {
  if (edit.verdict.state === 'infeasible') return colours.danger;
  const style = shownPlans.value.find(({ plan }) => plan.plan_id === edit.origin.plan_id)?.style ?? 0;
  return planColour(colours, style);
}

/** The line is dotted while the route has not been evaluated. */
function lineStyles({ verdict }: RouteEdit, color: string, colours: Palette): Style[] {
  const lineDash = verdict.state === 'ok' ? [] : [3, 7];
  return [
    new Style({ stroke: new Stroke({ color: colours.casing, width: 6 }) }),
    new Style({ stroke: new Stroke({ color, width: 3, lineDash }) }),
  ];
}

const middleStyle = (color: string, colours: Palette): Style =>
  new Style({ image: new Circle({ radius: 4, fill: new Fill({ color: colours.casing }), stroke: new Stroke({ color, width: 1.5 }) }) });

function handleStyle(index: number, chosen: boolean, color: string, colours: Palette): Style {
  return new Style({
    image: new Circle({
      radius: handleRadius_px,
      fill: new Fill({ color: chosen ? color : colours.casing }),
      stroke: new Stroke({ color: chosen ? colours.casing : color, width: 2 }),
    }),
    text: new Text({
      text: waypointLabel(index),
      font: '600 11px system-ui, sans-serif',
      offsetY: 1,
      fill: new Fill({ color: chosen ? colours.casing : color }),
    }),
    zIndex: chosen ? 3 : 2,
  });
}
