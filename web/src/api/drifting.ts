import { effect, untracked } from '@preact/signals';
import { around, contains, grown, intersection, rounded, width_deg } from '../geo/boxes';
import { wrapLongitude } from '../geo/geodesic';
import { chosenCurrents, chosenIcebergs, currentTimes_ms } from '../model/datasets';
import { drifts } from '../model/drift';
import { icebergs } from '../model/field';
import { visible } from '../model/layers';
import { isoOf } from '../model/time';
import { view } from '../model/view';
import * as api from './client';
import { Latest } from './latest';
import type { Box, Dataset } from './types';

/** What the server forecasts at once. */
const widest_deg = 10;
const highest_deg = 5;
const longest_ms = 10 * 86_400_000;

/** Keeps the forecast of the bergs in view in step with the view, the sightings and the currents. Call once. */
export function followDrift(): void {
  const latest = new Latest();
  let loaded: { key: string; box: Box } | undefined;
  effect(() => {
    const [bergs, currents, seen] = [chosenIcebergs.value, chosenCurrents.value, view.value];
    const end_ms = currentTimes_ms.value.at(-1);
    const sighted_ms = Math.max(...icebergs.value.map(({ properties }) => Date.parse(properties.observed)));
    const sighted = boxOf(bergs);
    const needed = seen && sighted && intersection(seen.box, sighted);
    if (!visible.value.drift || !currents || !needed || end_ms === undefined || !Number.isFinite(sighted_ms) || end_ms <= sighted_ms) {
      untracked(() => {
        latest.cancel();
        loaded = undefined;
        drifts.value = [];
      });
      return;
    }
    const key = [...bergs.map(({ id, sha256 }) => id + sha256), currents.id, sighted_ms].join('|');
    if (loaded?.key === key && contains(loaded.box, needed)) return;
    const box = rounded(bounded(grown(needed, 0.3)));
    if (loaded?.key === key && contains(loaded.box, box)) return;
    loaded = { key, box };
    const until_ms = Math.min(end_ms, sighted_ms + longest_ms);
    untracked(() => {
      latest.run(
        (signal) => Promise.all(bergs.map(({ id }) => api.drift({ box, as_of: isoOf(sighted_ms), until: isoOf(until_ms), dataset: id, currents: currents.id }, signal))),
        (answers) => {
          drifts.value = answers.flatMap((answer) => answer.bergs);
        },
        () => {
          drifts.value = []; // asked again with other sightings or another view only
        },
      );
    });
  });
}

/** Around all sightings, with room for a single one. */
const boxOf = (bergs: Dataset[]): Box | undefined => {
  const [first, ...others] = bergs.map(({ bbox }) => bbox);
  return first && widened(others.reduce(around, first));
};

const room_deg = 0.01;
const widened = ([west, south, east, north]: Box): Box =>
  width_deg([west, south, east, north]) + 2 * room_deg >= 360
    ? [-180, south - room_deg, 180, north + room_deg]
    : [wrapLongitude(west - room_deg), south - room_deg, wrapLongitude(east + room_deg), north + room_deg];

/** The middle of a box as far as the server answers. */
function bounded(box: Box): Box {
  const width = Math.min(width_deg(box), widest_deg);
  const height = Math.min(box[3] - box[1], highest_deg);
  const west = box[0] + (width_deg(box) - width) / 2;
  const south = box[1] + (box[3] - box[1] - height) / 2;
  return [wrapLongitude(west), south, wrapLongitude(west + width), south + height];
}
