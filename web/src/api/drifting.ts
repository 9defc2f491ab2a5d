import { effect, untracked } from '@preact/signals';
import { contains, grown, intersection, rounded, width_deg } from '../geo/boxes';
import { wrapLongitude } from '../geo/geodesic';
import { besideIcebergs, chosenCurrents, chosenIcebergs, currentTimes_ms } from '../model/datasets';
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
    const needed = seen && bergs && intersection(seen.box, boxOf(bergs, besideIcebergs.value));
    if (!visible.value.drift || !bergs || !currents || !needed || end_ms === undefined || !Number.isFinite(sighted_ms) || end_ms <= sighted_ms) {
      untracked(() => {
        latest.cancel();
        loaded = undefined;
        drifts.value = [];
      });
      return;
    }
    const reported = besideIcebergs.value;
    const key = [bergs.id, reported?.sha256, currents.id, sighted_ms].join('|');
    if (loaded?.key === key && contains(loaded.box, needed)) return;
    const box = rounded(bounded(grown(needed, 0.3)));
    if (loaded?.key === key && contains(loaded.box, box)) return;
    loaded = { key, box };
    const until_ms = Math.min(end_ms, sighted_ms + longest_ms);
    untracked(() => {
      latest.run(
        (signal) => api.drift({ box, as_of: isoOf(sighted_ms), until: isoOf(until_ms), dataset: reported ? undefined : bergs.id, currents: currents.id }, signal),
        (answer) => {
          drifts.value = answer.bergs;
        },
        () => {
          drifts.value = []; // asked again with other sightings or another view only
        },
      );
    });
  });
}

/** Around both; of datasets on either side of the antimeridian only the first. */
function boxOf({ bbox }: Dataset, beside: Dataset | undefined): Box {
  if (!beside || bbox[0] > bbox[2] || beside.bbox[0] > beside.bbox[2]) return bbox;
  const least = (i: 0 | 1): number => Math.min(bbox[i], beside.bbox[i]);
  const most = (i: 2 | 3): number => Math.max(bbox[i], beside.bbox[i]);
  return [least(0), least(1), most(2), most(3)];
}

/** The middle of a box as far as the server answers. */
function bounded(box: Box): Box {
  const width = Math.min(width_deg(box), widest_deg);
  const height = Math.min(box[3] - box[1], highest_deg);
  const west = box[0] + (width_deg(box) - width) / 2;
  const south = box[1] + (box[3] - box[1] - height) / 2;
  return [wrapLongitude(west), south, wrapLongitude(west + width), south + height];
}
