import { effect, signal, untracked } from '@preact/signals';
import { time_ms } from '../model/clock';
import { icebergs, icebergsAsOf_ms } from '../model/field';
import { icebergChoice, knownAt_ms, shownIcebergs } from '../model/setup/iceberg_choice';
import { hour_ms, isoOf } from '../model/time';
import * as api from './client';
import { Latest } from './latest';
import type { IcebergFeature } from '../contract/data_types';

/** While the clock moves, sightings are those of its whole hour; after this pause, those of its exact time. */
const rest_ms = 200;
const most = 200;

/** Keeps the icebergs of the set-up in step with the clock. Call once. */
export function followIcebergs(): void {
  const latest = new Latest();
  const remembered = new Map<string, IcebergFeature[]>();
  const restingClock = clockAtRest();
  let wanted = '';
  effect(() => {
    const choice = icebergChoice.value;
    const sources = shownIcebergs.value;
    const as_of_ms = knownAt_ms.value ?? restingClock.value;
    const key = choice && sources.length > 0 ? [...sources.map(({ id, sha256 }) => id + sha256), choice.max_sighting_age_days, choice.departure, as_of_ms].join('|') : '';
    if (key === wanted) return;
    wanted = key;
    const known = remembered.get(key);
    untracked(() => {
      if (key === '' || !choice || known) {
        latest.cancel();
        show(known ?? [], as_of_ms);
        return;
      }
      latest.run(
        (signal) => api.icebergsAt(isoOf(as_of_ms), choice, signal),
        ({ features }) => {
          const shown = icebergs.peek();
          const newest = isSame(features, shown) ? shown : features; // in most hours
          if (remembered.size > most) remembered.clear();
          remembered.set(key, newest);
          show(newest, as_of_ms);
        },
        () => {
          wanted = '';
        },
      );
    });
  });
}

const isSame = (some: IcebergFeature[], others: IcebergFeature[]): boolean =>
  some.length === others.length && some.every((berg, i) => JSON.stringify(berg) === JSON.stringify(others[i]));

/** Shows sightings. As long as they are the same list, nothing is computed again. */
function show(features: IcebergFeature[], as_of_ms: number): void {
  if (features === icebergs.value) return;
  icebergsAsOf_ms.value = as_of_ms;
  icebergs.value = features;
}

function clockAtRest(): { readonly value: number } {
  const shown = signal(time_ms.value);
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const now_ms = time_ms.value;
    clearTimeout(timer);
    const hourOf = (at_ms: number): number => Math.floor(at_ms / hour_ms);
    if (hourOf(shown.peek()) !== hourOf(now_ms)) shown.value = hourOf(now_ms) * hour_ms;
    timer = setTimeout(() => {
      shown.value = now_ms;
    }, rest_ms);
  });
  return shown;
}
