import { effect } from '@preact/signals';
import Feature from 'ol/Feature.js';
import Point from 'ol/geom/Point.js';
import type VectorLayer from 'ol/layer/Vector.js';
import VectorSource from 'ol/source/Vector.js';
import { Circle, Fill, RegularShape, Stroke, Style, Text } from 'ol/style.js';
import type { Position } from '../contract/data_types';
import { project } from '../geo/projections';
import { draft, hasGoalsFile, placeIn, placesIn } from '../model/setup/draft';
import { safePlaces } from '../model/plan/export_options';
import { openForm } from '../model/hand_made';
import { failure, isFailureOld } from '../model/job';
import { messagesOf, placeOf, shownMessage } from '../model/messages';
import { selectedId, selectedPlan } from '../model/plan/plans';
import { openEdit } from '../model/plan/route_edit';
import { probed } from '../model/probe';
import { projection } from '../model/settings';
import { rechecks } from '../model/stale';
import { palette, type Palette } from '../theme/palette';
import { StillLayer } from './still_layer';

/**
 * Start, goal and via points of the set-up; safe places of an export (R for recovery); the berg being reported; the
 * place where planning failed, until the set-up is changed; places of dangers and cautions of the selected plan and of its alternatives' messages;
 * the place probed last.
 */
export function markerLayer(): VectorLayer<VectorSource> {
  const source = new VectorSource();
  const layer = new StillLayer({ source, zIndex: 10 });
  effect(() => {
    const code = projection.value;
    const colours = palette.value;
    source.clear(true);
    const put = (place: Position | undefined, styles: Style[]): void => {
      if (!place) return;
      const feature = new Feature(new Point(project(code, place)));
      feature.setStyle(styles);
      source.addFeature(feature);
    };
    put(placeIn(draft.value.from), disc('S', colours.start, colours));
    const isTyped = !hasGoalsFile(draft.value);
    for (const [i, place] of isTyped ? placesIn(draft.value.via).places.entries() : []) put(place, disc(`V${i + 1}`, colours.label, colours));
    if (isTyped) put(placeIn(draft.value.to), disc('G', colours.goal, colours));

    for (const [i, place] of safePlaces.value.entries()) put(place, disc(`R${i + 1}`, colours.start, colours));

    const form = openForm.value;
    if (form?.berg) put(placeIn(form.berg.place), disc('B', colours.danger, colours));

    const plan = openEdit.value?.figures ?? selectedPlan.value;
    const ofAlternatives = selectedPlan.value?.alternatives?.map(({ message }) => message) ?? [];
    for (const message of plan ? [...messagesOf(plan), ...ofAlternatives] : []) {
      if (message.rank === 'note' && message !== shownMessage.value) continue;
      put(placeOf(message), alarm(message === shownMessage.value, message.rank === 'danger' ? colours.danger : colours.caution, colours));
    }
    const fault = failure.value;
    if (fault?.kind === 'infeasible' && !isFailureOld.value) put([fault.answer.at.lon, fault.answer.at.lat], cross(colours));
    const verdict = openEdit.value?.verdict;
    if (verdict?.state === 'infeasible') put([verdict.answer.at.lon, verdict.answer.at.lat], cross(colours));
    const checked = rechecks.value[selectedId.value ?? ''];
    if (checked?.state === 'infeasible') put([checked.answer.at.lon, checked.answer.at.lat], cross(colours));
    const probe = probed.value;
    if (probe) put([probe.lon, probe.lat], target(colours));
  });
  return layer;
}

function disc(letter: string, colour: string, colours: Palette): Style[] {
  return [
    new Style({
      image: new Circle({ radius: 10, fill: new Fill({ color: colour }), stroke: new Stroke({ color: colours.casing, width: 2.5 }) }),
      text: new Text({ text: letter, font: '700 12px system-ui, sans-serif', offsetY: 1, fill: new Fill({ color: colours.casing }) }),
    }),
  ];
}

function cross(colours: Palette): Style[] {
  const arms = (width: number, color: string): Style =>
    new Style({
      image: new RegularShape({ points: 4, radius: 13, radius2: 0, angle: Math.PI / 4, stroke: new Stroke({ color, width }) }),
    });
  const ring = new Style({
    image: new Circle({ radius: 19, stroke: new Stroke({ color: colours.danger, width: 2.5, lineDash: [6, 4] }) }),
  });
  return [ring, arms(7, colours.casing), arms(3.5, colours.danger)];
}

function target(colours: Palette): Style[] {
  const ring = (width: number, color: string): Style =>
    new Style({ image: new Circle({ radius: 8, stroke: new Stroke({ color, width }) }) });
  return [ring(4.5, colours.casing), ring(2, colours.ink)];
}

/** How far a sign stands below its place, so that its tip points at the mark there, such as the one for no surfacing. */
const below_px = 18;

/** A triangle with an exclamation mark; with a ring around its place if the user asked for its message. */
function alarm(asked: boolean, colour: string, colours: Palette): Style[] {
  const sign = new Style({
    image: new RegularShape({ points: 3, radius: 12, displacement: [0, -below_px], fill: new Fill({ color: colour }), stroke: new Stroke({ color: colours.casing, width: 2 }) }),
    text: new Text({ text: '!', font: '800 12px system-ui, sans-serif', offsetY: below_px + 1, fill: new Fill({ color: colours.casing }) }),
  });
  const ring = new Style({ image: new Circle({ radius: 19, stroke: new Stroke({ color: colour, width: 2.5 }) }) });
  return asked ? [ring, sign] : [sign];
}
