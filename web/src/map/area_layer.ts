import { effect, untracked } from '@preact/signals';
import Feature from 'ol/Feature.js';
import type { ColorLike } from 'ol/colorlike.js';
import Polygon from 'ol/geom/Polygon.js';
import { Draw } from 'ol/interaction.js';
import type VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Circle, Fill, Stroke, Style, Text } from 'ol/style.js';
import type { Position } from '../contract/data_types';
import { densify } from '../geo/geodesic';
import { unproject } from '../geo/projections';
import { areaOf, newArea, type Area } from '../model/area';
import { chosenAll } from '../model/datasets';
import { draft, edit } from '../model/setup/draft';
import { drawingWish, drawnCorners, fewestCorners, isDrawing } from '../model/drawing';
import { newZone, openForm, zones } from '../model/hand_made';
import { visible } from '../model/layers';
import { areasOfPlanAlone } from '../model/plan/plan_areas';
import { selectedShown } from '../model/plan/plans';
import { announce } from '../model/screen';
import { projection } from '../model/settings';
import { tool } from '../model/view';
import { palette, type Palette } from '../theme/palette';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/**
 * Stored zones, areas of the set-up and of the selected plan, and the tool that draws an area. Closed areas are hatched. Areas that the set-up does
 * not use, or that are not stored yet, are outlines. Sides are geodesics.
 */
export function areaLayer(): { layer: VectorLayer<VectorSource>; draw: Draw } {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 4 });
  effect(() => {
    const code = projection.value;
    const colours = palette.value;
    source.clear(true);
    const form = openForm.value;
    const stored = zones.value.filter(({ id }) => id !== form?.before?.id || form.kind !== 'zones');
    const obeyed = chosenAll('zones').map(({ id }) => id);
    const put = (area: Area, style: Style[]): void => {
      const [first] = area.corners;
      if (!first) return;
      const feature = new Feature(new Polygon([toMap(code, densify([...area.corners, first], 2000))]));
      feature.setStyle(style);
      source.addFeature(feature);
    };
    for (const zone of stored) {
      const area = areaOf(zone);
      put(area, obeyed.includes(zone.properties.dataset_id) ? areaStyle(area, colours) : asideStyle(area, 'not used', colours));
    }
    if (form?.zone) put(form.zone, asideStyle(form.zone, 'not stored yet', colours));
    for (const area of draft.value.areas) put(area, areaStyle(area, colours));
    const plan = selectedShown.value;
    for (const area of plan ? areasOfPlanAlone.value : []) put(area, areaStyle({ ...area, name: `${plan?.letter ?? ''}: ${area.name}` }, colours));
  });
  effect(() => layer.setVisible(visible.value.areas));

  const draw = new Draw({ type: 'Polygon', stopClick: true });
  draw.on('drawend', ({ feature }) => {
    const rings = (feature.getGeometry() as Polygon).getCoordinates();
    const corners = (rings[0] ?? []).slice(0, -1).map(([x = 0, y = 0]): Position => unproject(projection.peek(), [x, y]));
    if (tool.peek() === 'zone') {
      drawZone(corners);
      return;
    }
    const { areas } = draft.peek();
    edit({ areas: [...areas, newArea(corners, areas.length + 1)] });
    announce(`Area ${areas.length + 1} to keep out of, ${corners.length} corners.`);
    tool.value = 'pan';
  });
  draw.on('drawstart', ({ feature }) => {
    const sketch = feature.getGeometry() as Polygon;
    const count = (): void => {
      // without the pointer's place and the closing corner
      drawnCorners.value = Math.max(0, (sketch.getCoordinates()[0]?.length ?? 0) - 2);
    };
    sketch.on('change', count);
    count();
  });
  draw.on(['drawend', 'drawabort'], () => {
    drawnCorners.value = 0;
  });
  effect(() => draw.setActive(isDrawing.value));
  effect(() => {
    const wish = drawingWish.value;
    untracked(() => {
      if (wish?.do === 'removeLast') draw.removeLastPoint();
      if (wish?.do === 'corner') draw.appendCoordinates(toMap(projection.peek(), [wish.place]));
      if (wish?.do !== 'close') return;
      if (drawnCorners.peek() >= fewestCorners) draw.finishDrawing();
      else announce('An area needs three corners or more.');
    });
  });
  effect(() => {
    const { danger, dangerFill, casing } = palette.value;
    draw.getOverlay().setStyle(
      new Style({
        fill: new Fill({ color: dangerFill }),
        stroke: new Stroke({ color: danger, width: 2, lineDash: [6, 4] }),
        image: new Circle({ radius: 5, fill: new Fill({ color: casing }), stroke: new Stroke({ color: danger, width: 2 }) }),
      }),
    );
  });
  return { layer, draw };
}

/** The corners of the open form's zone, or of a new one. */
function drawZone(corners: Position[]): void {
  const form = openForm.peek();
  openForm.value = form?.zone ? { ...form, zone: { ...form.zone, corners } } : newZone(corners);
  announce(`Zone with ${corners.length} corners.`);
  tool.value = 'pan';
}

function areaStyle({ kind, name, from, until, top_m, bottom_m }: Area, colours: Palette): Style[] {
  const closed = kind === 'no_go';
  const color = closed ? colours.danger : colours.start;
  const times = from || until ? [`${from || '…'} – ${until || '…'}`] : [];
  const depths = top_m || bottom_m ? [`${top_m || '0'} – ${bottom_m ? `${bottom_m} m` : 'sea bed'}`] : [];
  const outline = new Style({
    ...(closed ? { fill: new Fill({ color: hatching(color) }) } : {}),
    stroke: new Stroke({ color, width: 2, ...(closed ? {} : { lineDash: [10, 5] }) }),
  });
  return [outline, ...lineStyles([name, ...depths, ...times], color, colours)];
}

/** Only an outline, because no plan obeys the area. */
const asideStyle = ({ name }: Area, why: string, colours: Palette): Style[] => [
  new Style({ stroke: new Stroke({ color: colours.stale, width: 1.5, lineDash: [2, 4] }) }), ...lineStyles([`${name} (${why})`], colours.stale, colours),
];

const lineHeight_px = 15;

/** The lines of a name inside an area. OpenLayers leaves out each that is wider than the area, so that on small maps names do not lie on each other. */
const lineStyles = (lines: string[], color: string, colours: Palette): Style[] =>
  lines.map((text, i) => new Style({
    text: new Text({
      text, font: '600 12px system-ui, sans-serif', offsetY: lineHeight_px * (i - (lines.length - 1) / 2), fill: new Fill({ color }),
      stroke: new Stroke({ color: colours.halo, width: 3.5 }),
    }),
  }));

/** Diagonal lines, so that a closed area does not depend on colour alone. */
function hatching(color: string): ColorLike {
  const size = 10;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d');
  if (!context) return color;
  context.strokeStyle = color;
  context.globalAlpha = 0.5;
  context.lineWidth = 1.4;
  for (const shift of [-size, 0, size]) {
    context.moveTo(shift - 1, size + 1);
    context.lineTo(shift + size + 1, -1);
  }
  context.stroke();
  return context.createPattern(canvas, 'repeat') ?? color;
}
