import { effect, untracked, type Signal } from '@preact/signals';
import { contains, grown, intersection, rounded, width_deg } from '../geo/boxes';
import type { Grid, TimedPair } from '../geo/grid';
import { bracket, heldStep, time_ms } from '../model/clock';
import { chosenBathymetry, chosenCoastline, chosenCurrents, chosenSeaIce, currentTimes_ms, seaIceTimes_ms } from '../model/datasets';
import { bathymetry, coast, currents, currentsFault, seaIce, seaIceFault } from '../model/field';
import { visible } from '../model/layers';
import { longestSeaIceGap_ms, longestSeaIceHold_ms } from '../model/ice/sea_ice';
import { chosenChart, iceChart } from '../model/ice/ice_chart';
import { isoOf } from '../model/time';
import { view, type View } from '../model/view';
import * as api from './client';
import { Latest } from './latest';
import { followIcebergs } from './sightings';
import type { Box, Dataset } from '../contract/data_types';

/** Keeps the loaded data in step with the view, the clock and the chosen datasets. Call once. */
export function followFields(): void {
  followBathymetry();
  followCoast();
  followIceChart();
  followStepped({
    dataset: () => chosenCurrents.value, times_ms: () => currentTimes_ms.value, cell_px: 9, load: api.currents, pair: currents, fault: currentsFault, name: 'current',
  });
  followStepped({
    dataset: () => chosenSeaIce.value, times_ms: () => seaIceTimes_ms.value, longestGap_ms: longestSeaIceGap_ms, longestHold_ms: longestSeaIceHold_ms,
    cell_px: 7, load: api.seaIce, pair: seaIce, fault: seaIceFault, name: 'sea ice',
  });
  followIcebergs();
}

interface Window {
  dataset: string;
  box: Box;
  nx: number;
  ny: number;
}

/**
 * The window to request: the view with a margin, inside the dataset; the old window as long as it is large and fine
 * enough.
 */
function windowFor(dataset: Dataset, seen: View, cell_px: number, most: number, old: Window | undefined): Window | undefined {
  const needed = intersection(seen.box, dataset.bbox);
  if (!needed) return undefined;
  const sharp = old && width_deg(old.box) < 1.8 * width_deg(intersection(grown(seen.box, 0.3), dataset.bbox) ?? needed);
  if (sharp && old.dataset === dataset.id && contains(old.box, rounded(needed).map((v, i) => v + (i < 2 ? 1e-3 : -1e-3)) as Box)) return old;

  const box = intersection(grown(seen.box, 0.3), dataset.bbox);
  if (!box) return undefined;
  const share = (part: number, whole: number): number => Math.min(1, part / whole);
  const cells = (pixels: number, part: number): number => Math.round(Math.min(most, Math.max(24, ((1.6 * pixels) / cell_px) * part)));
  return {
    dataset: dataset.id,
    box: rounded(box),
    nx: cells(seen.width_px, Math.max(0.4, share(width_deg(box), 1.6 * width_deg(seen.box)))),
    ny: cells(seen.height_px, Math.max(0.4, share(box[3] - box[1], 1.6 * (seen.box[3] - seen.box[1])))),
  };
}

function followBathymetry(): void {
  const latest = new Latest();
  let window: Window | undefined;
  effect(() => {
    const dataset = chosenBathymetry.value;
    const seen = view.value;
    if (!visible.value.bathymetry) return;
    if (!dataset || !seen) {
      bathymetry.value = undefined;
      window = undefined;
      return;
    }
    const next = windowFor(dataset, seen, 2.2, 900, window);
    if (!next || next === window) return;
    window = next;
    untracked(() => {
      latest.run(
        (signal) => api.bathymetry(next.box, next.nx, next.ny, next.dataset, signal),
        (grid) => {
          bathymetry.value = grid;
        },
        () => {
          window = undefined;
        },
      );
    });
  });
}

function followCoast(): void {
  const latest = new Latest();
  let loaded: { dataset: string; box: Box } | undefined;
  effect(() => {
    const dataset = chosenCoastline.value;
    const seen = view.value;
    if (!dataset || !seen) {
      coast.value = [];
      loaded = undefined;
      return;
    }
    if (loaded?.dataset === dataset.id && contains(loaded.box, seen.box)) return;
    const box = rounded(grown(seen.box, 0.5));
    loaded = { dataset: dataset.id, box };
    untracked(() => {
      latest.run(
        (signal) => api.coast(box, signal),
        ({ features }) => {
          coast.value = features;
        },
        () => {
          loaded = undefined;
        },
      );
    });
  });
}

/**
 * Loads the polygons of the chosen ice chart for an area a little larger than the view, at the resolution of the
 * screen.
 */
function followIceChart(): void {
  const latest = new Latest();
  let loaded: { dataset: string; box: Box; columns: number } | undefined;
  effect(() => {
    const chart = chosenChart.value;
    const seen = view.value;
    if (!visible.value.iceChart) return;
    const box = chart && seen && intersection(grown(seen.box, 0.3), chart.bbox);
    if (!box) {
      latest.cancel();
      iceChart.value = undefined;
      loaded = undefined;
      return;
    }
    // A smaller part of the chart is loaded at the same resolution as the whole view.
    const columns = Math.min(8192, Math.max(64, Math.round((seen.width_px * width_deg(box)) / width_deg(seen.box))));
    const fine = loaded && width_deg(box) / columns > 0.6 * (width_deg(loaded.box) / loaded.columns);
    const needed = intersection(seen.box, chart.bbox);
    if (fine && loaded?.dataset === chart.id && needed && contains(loaded.box, needed)) return;
    loaded = { dataset: chart.id, box, columns };
    untracked(() => {
      latest.run(
        (signal) => api.iceChart(box, columns, chart.id, signal),
        (answer) => {
          iceChart.value = answer;
        },
        () => {
          loaded = undefined;
        },
      );
    });
  });
}

const rememberedGrids = 24;

/** A field with time steps, which are loaded around the clock's time. */
interface Stepped {
  dataset: () => Dataset | undefined;
  times_ms: () => number[];
  longestGap_ms?: number; // there is no value between two steps further apart than this
  longestHold_ms?: number; // up to this long before the first and after the last step, that step's values are used
  cell_px: number;
  load: (box: Box, nx: number, ny: number, time: string, dataset: string) => Promise<Grid>;
  pair: Signal<TimedPair | undefined>;
  fault: Signal<string | undefined>;
  name: string; // name in messages: "No current data here"
}

function followStepped({ dataset: chosenDataset, times_ms, longestGap_ms, longestHold_ms = 0, cell_px, load: ask, pair, fault, name }: Stepped): void {
  const latest = new Latest();
  const remembered = new Map<string, Promise<Grid>>();
  let window: Window | undefined;
  let shownKey = '';
  let loadingKey = '';

  // A request for a grid is never aborted: the next clock step may need it, and the answer is cached.
  const load = (from: Window, at_ms: number): Promise<Grid> => {
    const key = [from.dataset, from.box, from.nx, from.ny, at_ms].join('|');
    const known = remembered.get(key);
    if (known) {
      remembered.delete(key); // added again below as the newest
      remembered.set(key, known);
      return known;
    }
    const grid = ask(from.box, from.nx, from.ny, isoOf(at_ms), from.dataset);
    remembered.set(key, grid);
    grid.catch(() => remembered.delete(key));
    for (const oldest of remembered.keys()) {
      if (remembered.size <= rememberedGrids) break;
      remembered.delete(oldest);
    }
    return grid;
  };
  const clear = (why: string | undefined): void => {
    latest.cancel();
    shownKey = '';
    loadingKey = '';
    pair.value = undefined;
    fault.value = why;
  };

  effect(() => {
    const dataset = chosenDataset();
    const seen = view.value;
    const times = times_ms();
    const now_ms = time_ms.value;
    if (!dataset || !seen) {
      untracked(() => clear(undefined));
      return;
    }
    const steps = bracket(times, now_ms, longestGap_ms) ?? heldStep(times, now_ms, longestHold_ms);
    const before = steps && times[steps.before];
    const after = steps && times[steps.after];
    const next = windowFor(dataset, seen, cell_px, 200, window);
    if (!steps || before === undefined || after === undefined || !next) {
      untracked(() => clear(next ? `No ${name} data at this time` : `No ${name} data here`));
      return;
    }
    window = next;
    const key = [next.dataset, next.box, before, after].join('|');
    untracked(() => {
      const shownPair = pair.value;
      if (key === shownKey && shownPair) {
        pair.value = { ...shownPair, share: steps.share };
        return;
      }
      if (key === loadingKey) return;
      loadingKey = key;
      latest.run(
        () => Promise.all([load(next, before), load(next, after)]),
        ([first, second]) => {
          shownKey = key;
          loadingKey = '';
          const fresh = bracket(times, time_ms.value, longestGap_ms) ?? heldStep(times, time_ms.value, longestHold_ms);
          pair.value = { before: first, after: second, share: fresh?.before === steps.before ? fresh.share : steps.share };
          fault.value = undefined;
          const ahead = times[steps.after + 1];
          if (ahead !== undefined) void load(next, ahead).catch(() => undefined);
        },
        (why) => {
          clear(why);
        },
      );
    });
  });
}
