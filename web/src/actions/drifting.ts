import { effect, untracked } from '@preact/signals';
import { around, contains, grown, intersection, rounded, width_deg } from '../geo/boxes';
import { wrapLongitude } from '../geo/geodesic';
import { chosenCurrents, currentTimes_ms } from '../model/datasets';
import { drifts, driftsLeftOut } from '../model/ice/drift';
import { draft } from '../model/setup/draft';
import { icebergs, icebergsAsOf_ms } from '../model/field';
import { icebergChoice, shownIcebergs, type IcebergChoice } from '../model/setup/iceberg_choice';
import { visible } from '../model/layers';
import { isoOf } from '../model/time';
import { view } from '../model/view';
import * as api from './client';
import { Latest } from './latest';
import type { Box, IcebergFeature } from '../contract/data_types';

/** Limits of one forecast request: the server's own. */
const widest_deg = 10;
const highest_deg = 5;
const longest_ms = 10 * 86_400_000;

/** Keeps the forecast of the bergs in view in step with the view, the sightings and the currents. Call once. */
export function followDrift(): void {
  const latest = new Latest();
  let loaded: { key: string; box: Box } | undefined;
  effect(() => {
    const [bergs, currents, seen] = [icebergs.value, chosenCurrents.value, view.value];
    const [choice, as_of_ms, end_ms] = [icebergChoice.value, icebergsAsOf_ms.value, currentTimes_ms.value.at(-1)];
    const sighted_ms = Math.max(...bergs.map(({ properties }) => Date.parse(properties.observed)));
    const sighted = boxOf(bergs);
    const needed = seen && sighted && intersection(seen.box, sighted);
    if (!visible.value.drift || !choice || !currents || !needed || end_ms === undefined || as_of_ms === undefined || end_ms <= sighted_ms) {
      untracked(() => {
        latest.cancel();
        loaded = undefined;
        drifts.value = [];
      });
      return;
    }
    const key = [...shownIcebergs.value.map(({ id, sha256 }) => id + sha256), choice.datasets?.join(' '), choice.max_sighting_age_days, choice.departure, draft.value.currents, currents.id, as_of_ms].join('|');
    if (loaded?.key === key && contains(loaded.box, needed)) return;
    const box = rounded(bounded(grown(needed, 0.3)));
    if (loaded?.key === key && contains(loaded.box, box)) return;
    loaded = { key, box };
    const until_ms = Math.max(as_of_ms, Math.min(end_ms, as_of_ms + longest_ms));
    // For joined currents the server chooses, because it knows the runs.
    const currentsWish = draft.peek().currents === 'newest' ? undefined : currents.id;
    untracked(() => {
      latest.run(
        (signal) => api.drift({ box, as_of: isoOf(as_of_ms), until: isoOf(until_ms), choice: thoseIn(bergs, choice), currents: currentsWish }, signal),
        (answer) => {
          const shown = new Set(bergs.map(({ properties }) => keyOf(properties)));
          drifts.value = answer.bergs.filter((berg) => shown.has(keyOf(berg)));
          driftsLeftOut.value = answer.numberMatched - answer.bergs.length;
        },
        () => {
          drifts.value = []; // requested again only after the sightings or the view have changed
        },
      );
    });
  });
}

/** The choice without datasets that have no iceberg in view, because the server refuses those. */
const thoseIn = (bergs: IcebergFeature[], { datasets, ...others }: IcebergChoice): IcebergChoice => ({
  ...others, datasets: datasets?.filter((id) => bergs.some(({ properties }) => properties.dataset_id === id)),
});

const keyOf = ({ berg_id, observed }: { berg_id: string; observed: string }): string => `${berg_id}|${observed}`;

/** A box around all sightings, widened so that a single sighting has room. */
const boxOf = (bergs: IcebergFeature[]): Box | undefined => {
  const [first, ...others] = bergs.map(({ geometry: { coordinates: [lon, lat] } }): Box => [lon, lat, lon, lat]);
  return first && widened(others.reduce(around, first));
};

const room_deg = 0.01;
const widened = ([west, south, east, north]: Box): Box =>
  width_deg([west, south, east, north]) + 2 * room_deg >= 360
    ? [-180, south - room_deg, 180, north + room_deg]
    : [wrapLongitude(west - room_deg), south - room_deg, wrapLongitude(east + room_deg), north + room_deg];

/** The middle part of a box, as large as the server accepts. */
function bounded(box: Box): Box {
  const width = Math.min(width_deg(box), widest_deg);
  const height = Math.min(box[3] - box[1], highest_deg);
  const west = box[0] + (width_deg(box) - width) / 2;
  const south = box[1] + (box[3] - box[1] - height) / 2;
  return [wrapLongitude(west), south, wrapLongitude(west + width), south + height];
}
