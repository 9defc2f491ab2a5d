import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import MultiPolygon from 'ol/geom/MultiPolygon.js';
import Point from 'ol/geom/Point.js';
import type VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Fill, Stroke, Style, Text } from 'ol/style.js';
import type { Position } from '../contract/data_types';
import { project } from '../geo/projections';
import { visible } from '../model/layers';
import { reach } from '../model/reach';
import { projection } from '../model/settings';
import { palette } from '../theme/palette';
import { labelsWithRoom, type Label } from './label_room';
import { toMap } from './projections';
import { StillLayer } from './still_layer';

/** Isochrones: one line for each number of hours, thinner for later ones, labelled at the northern end. */
export function reachLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 3 });
  effect(() => {
    const code = projection.value;
    const { reach: color, reachFill, halo } = palette.value;
    const shown = reach.value;
    source.clear(true);
    if (shown?.state !== 'ok') return;
    const names: { label: Label; style: Style }[] = [];
    shown.answer.features.forEach(({ geometry, properties }, i) => {
      const area = new Feature(new MultiPolygon(geometry.coordinates.map((rings) => rings.map((ring) => toMap(code, ring)))));
      area.setStyle(new Style({ fill: new Fill({ color: reachFill }), stroke: new Stroke({ color, width: Math.max(1.2, 2.6 - 0.5 * i) }) }));
      source.addFeature(area);
      const top = northernmost(geometry.coordinates.flatMap(([outer]) => outer ?? []));
      if (!top) return;
      const text = `${properties.hours} h`;
      const style = new Style({
        text: new Text({ text, font: '700 12px system-ui, sans-serif', offsetY: -9, fill: new Fill({ color }), stroke: new Stroke({ color: halo, width: 3.5 }) }),
      });
      names.push({ label: { at: project(code, top), text }, style });
    });
    const withRoom = labelsWithRoom(names.map(({ label }) => label));
    for (const { label, style } of names) {
      const name = new Feature(new Point(label.at));
      name.setStyle((_, resolution) => (withRoom(resolution).has(label) ? style : undefined));
      source.addFeature(name);
    }
  });
  effect(() => layer.setVisible(visible.value.reach && reach.value?.state === 'ok'));
  return layer;
}

function northernmost(ring: Position[]): Position | undefined {
  return ring.reduce<Position | undefined>((top, place) => (!top || place[1] > top[1] ? place : top), undefined);
}
