import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import LineString from 'ol/geom/LineString.js';
import Point from 'ol/geom/Point.js';
import VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Circle, Fill, Icon, RegularShape, Stroke, Style, Text } from 'ol/style.js';
import type { Waypoint } from '../contract/types';
import { densify } from '../geo/geodesic';
import { northAngle, project, type ProjectionCode } from '../geo/projections';
import { time_ms } from '../model/clock';
import { hold_s, holdText } from '../model/plan/holds';
import { visible } from '../model/layers';
import { selectedId, selectedShown, selectedWaypoint, shownPlans, vehicleAt, waypointLabel, type ShownPlan } from '../model/plan/plans';
import { openEdit } from '../model/plan/route_edit';
import { projection } from '../model/settings';
import { runsOf } from '../model/ice/under_ice';
import { belowIceDash, palette, planColour, planDash, tunnelDash, type Palette } from '../theme/palette';
import { labelsWithRoom } from './label_room';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/**
 * Lines of the plans: a white casing, then colour and dash pattern; the selected one uppermost and thicker. Stretches below ice are
 * drawn as maps draw tunnels: short dashes between broken edges.
 */
export function planLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 6, updateWhileInteracting: true, updateWhileAnimating: true });
  effect(() => {
    const code = projection.value;
    const selected = selectedId.value;
    source.clear(true);
    for (const shown of shownPlans.value) {
      for (const { places, isBelowIce } of runsOf(shown.plan)) {
        const line = new Feature(new LineString(toMap(code, densify(places, 2000))));
        line.setStyle(lineStyles(shown, isBelowIce, shown.plan.plan_id === selected, palette.value));
        line.set('planId', shown.plan.plan_id);
        source.addFeature(line);
      }
    }
  });
  effect(() => layer.setVisible(visible.value.plans));
  return layer;
}

function lineStyles({ style }: ShownPlan, isBelowIce: boolean, selected: boolean, colours: Palette): Style[] {
  const width = selected ? 3 : 2;
  const zIndex = selected ? 2 : 1;
  const lineDash = isBelowIce ? [...belowIceDash] : planDash(style);
  return [
    ...(isBelowIce ? [new Style({ stroke: new Stroke({ color: colours.ink, width: width + 6, lineDash: [...tunnelDash], lineCap: 'butt' }), zIndex })] : []),
    new Style({ stroke: new Stroke({ color: colours.casing, width: width + 3 }), zIndex }),
    new Style({
      stroke: new Stroke({ color: planColour(colours, style), width, lineDash, ...(isBelowIce ? { lineCap: 'butt' as const } : {}) }),
      zIndex,
    }),
  ];
}

const holdRing_px = 11;

/**
 * Waypoints of the selected plan, unless a copy of it is being edited: a dot each, a square where the vehicle may not
 * surface, and the name if there is room. The chosen waypoint, start, goal and holds get theirs first.
 */
export function waypointLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 8 });
  effect(() => {
    const code = projection.value;
    const colours = palette.value;
    const chosen = selectedWaypoint.value;
    const shown = openEdit.value ? undefined : selectedShown.value;
    source.clear(true);
    if (!shown) return;
    const { plan: { plan_id, waypoints }, style } = shown;
    const goal = waypoints.length - 1;
    const labels = waypoints.map((waypoint) => ({
      at: project(code, [waypoint.lon, waypoint.lat]), text: nameOf(waypoint), rank: waypoint.index === chosen ? 0 : waypoint.index === 0 || waypoint.index === goal || hold_s(waypoint) > 0 ? 1 : 2,
    }));
    const withRoom = labelsWithRoom([...labels].sort((a, b) => a.rank - b.rank));
    waypoints.forEach((waypoint, i) => {
      const label = labels[i];
      if (!label) return;
      const isChosen = waypoint.index === chosen;
      const [marks, name] = [markStyles(waypoint, style, isChosen, colours), nameStyle(label.text, style, isChosen, colours)];
      const feature = new Feature(new Point(label.at));
      feature.set('waypoint', waypoint.index);
      feature.set('planId', plan_id);
      feature.set('name', waypointLabel(waypoint.index));
      feature.setStyle((_, resolution) => (withRoom(resolution).has(label) ? [...marks, name] : marks));
      source.addFeature(feature);
    });
  });
  effect(() => layer.setVisible(visible.value.plans));
  return layer;
}

/** The number of a waypoint, and how long the vehicle holds there. */
const nameOf = (waypoint: Waypoint): string => [waypointLabel(waypoint.index), ...(hold_s(waypoint) > 0 ? [holdText(waypoint)] : [])].join(' ');

/** Marks of a waypoint; a hold is a ring around it. */
function markStyles(waypoint: Waypoint, style: number, chosen: boolean, colours: Palette): Style[] {
  const colour = planColour(colours, style);
  const fill = new Fill({ color: chosen ? colour : colours.casing });
  const dot = new Circle({ radius: chosen ? 6 : 3.5, fill, stroke: new Stroke({ color: colour, width: 2 }) });
  const closed = new RegularShape({
    points: 4, angle: Math.PI / 4, radius: chosen ? 9 : 6.5, fill: new Fill({ color: colour }), stroke: new Stroke({ color: chosen ? colours.ink : colours.casing, width: 2 }),
  });
  const ring = (width: number, color: string): Style => new Style({ image: new Circle({ radius: holdRing_px, stroke: new Stroke({ color, width }) }), zIndex: 1 });
  return [
    ...(hold_s(waypoint) > 0 ? [ring(5, colours.casing), ring(2, colour)] : []),
    new Style({ image: waypoint.may_surface === false ? closed : dot, zIndex: 1 }),
  ];
}

const nameStyle = (text: string, style: number, chosen: boolean, colours: Palette): Style =>
  new Style({
    text: new Text({
      text,
      textAlign: 'left',
      font: `600 ${chosen ? 13 : 11}px system-ui, sans-serif`,
      offsetX: 8,
      offsetY: -10,
      fill: new Fill({ color: planColour(colours, style) }),
      stroke: new Stroke({ color: colours.casing, width: 3.5 }),
    }),
    zIndex: chosen ? 3 : 2,
  });

/** Where each shown plan's vehicle is at the clock's time, pointing along its course. */
export function vehicleLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new VectorLayer({ source, zIndex: 9, updateWhileInteracting: true, updateWhileAnimating: true });
  effect(() => {
    const code = projection.value;
    source.clear(true);
    for (const shown of shownPlans.value) {
      const now = vehicleAt(shown.plan, time_ms.value);
      if (!now) continue;
      const feature = new Feature(new Point(project(code, now.place)));
      feature.setStyle(vehicleStyles(shown, screenTurn(code, now.place, now.course_deg), palette.value));
      source.addFeature(feature);
    }
  });
  effect(() => layer.setVisible(visible.value.plans));
  return layer;
}

/** Clockwise turn in radians, from the projection's y axis, of a course at a place. */
function screenTurn(code: ProjectionCode, place: [number, number], course_deg: number): number {
  return Math.PI / 2 - northAngle(code, place) + (course_deg * Math.PI) / 180;
}

/** An arrow head that points up. */
function arrowImage(fill: string, casing: string): string {
  const path = `<path d="M14 3 L23 25 L14 20.5 L5 25 Z" fill="${fill}" stroke="${casing}" stroke-width="2.5" stroke-linejoin="round"/>`;
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="28" height="28">${path}</svg>`;
  return `data:image/svg+xml,${encodeURIComponent(svg)}`;
}

/** The letter stands below the name of a waypoint. */
const letterRight_px = 20;
const letterDown_px = 3;

function vehicleStyles({ style, letter }: ShownPlan, rotation: number, colours: Palette): Style[] {
  const colour = planColour(colours, style);
  return [
    new Style({ image: new Icon({ src: arrowImage(colour, colours.casing), rotation, rotateWithView: true }) }),
    new Style({
      text: new Text({
        text: letter,
        offsetX: letterRight_px,
        offsetY: letterDown_px,
        font: '700 12px system-ui, sans-serif',
        fill: new Fill({ color: colour }),
        stroke: new Stroke({ color: colours.casing, width: 4 }),
      }),
    }),
  ];
}
