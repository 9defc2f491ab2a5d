import { computed, effect, untracked } from '@preact/signals';
import { range, setSpan, setTime } from '../model/clock';
import { coveredDatasets } from '../model/coverage';
import { connectionFault, chosenBathymetry, chosenCurrents, currentTimes_ms, datasets, forgetMissing, homeBox, takeStored, vehicles } from '../model/datasets';
import { draft, fill } from '../model/setup/draft';
import * as model from '../model/plan/plans';
import { dataArea } from '../model/position';
import type { Link } from '../model/link';
import { opening } from '../model/shared_view';
import { shownFlight } from '../model/plan/simulations';
import { chosenTrack, gliderTracks } from '../model/tracks';
import { announce, tell } from '../model/screen';
import { fieldOf, hour_ms } from '../model/time';
import { time_ms } from '../model/clock';
import { ask } from '../model/view';
import { borderOf } from '../geo/boxes';
import * as api from './client';
import { withoutDeleted } from './deleting';

const faultOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Reads the content of the store. Call at start and when the user asks for it. */
export async function refresh(): Promise<void> {
  try {
    const planned = api.plans();
    planned.catch(() => undefined); // reported below, unless another request fails first
    const [stored, known] = await Promise.all([api.datasets(), api.vehicles()]);
    takeStored(stored);
    vehicles.value = known.vehicles;
    if (draft.value.vehicle === '') fill({ vehicle: known.vehicles[0]?.name ?? '' });
    model.plans.value = model.inOrder(withoutDeleted((await planned).map((feature) => feature.properties)));
    connectionFault.value = undefined;
    if (model.shown.value.length === 0) showFirst(opening);
  } catch (error) {
    connectionFault.value = faultOf(error);
  }
}

/** Shows the stored plans named in the address, or else the newest plan. */
function showFirst({ plans = [], selected }: Link): void {
  const stored = plans.filter((id) => model.plans.value.some(({ plan_id }) => plan_id === id));
  model.shown.value = stored;
  const chosen = stored.find((id) => id === selected) ?? stored[0] ?? model.plans.value[0]?.plan_id;
  if (chosen !== undefined) model.select(chosen);
}

/** Lets the reading of positions use the area of the data. Call once. */
export function followDataArea(): void {
  effect(() => {
    dataArea.value = chosenCurrents.value || chosenBathymetry.value ? homeBox.value : undefined;
  });
}

/** Shows the area of the first data that are added to an empty store. Call once. */
export function followFirstData(): void {
  let awaited = false; // the store was empty, and has no currents yet
  effect(() => {
    if (datasets.value === undefined) return;
    if (datasets.value.length === 0) awaited = true;
    else if (awaited && dataArea.value) {
      awaited = chosenCurrents.value === undefined;
      ask({ do: 'fit', places: borderOf(dataArea.value) });
    }
  });
}

/** Removes datasets that are no longer stored from the set-up. Call once. */
export function followStore(): void {
  effect(() => {
    if (datasets.value === undefined) return;
    const lost = untracked(forgetMissing);
    if (lost.length > 0) tell(`Data that the set-up named are gone from the store: ${lost.join(', ')}. It uses the rest.`);
  });
}

/**
 * Keeps the clock's range in step with the currents, and with the plans, the flight and the coverage shown. Call once.
 */
export function followSpans(): void {
  let opened = false;
  effect(() => {
    const times = currentTimes_ms.value;
    const [start_ms, end_ms] = [times[0], times.at(-1)];
    untracked(() => {
      const known = start_ms !== undefined && end_ms !== undefined;
      setSpan('currents', known ? { start_ms, end_ms } : undefined);
      if (opened || !known || !chosenCurrents.value) return;
      opened = true;
      openAt(start_ms, end_ms);
    });
  });

  followSpansOf(() => model.shownPlans.value.map(({ plan }) => ({ id: plan.plan_id, from: plan.departure, to: plan.arrival })));
  followSpansOf(() => (shownFlight.value ? [{ id: 'flight', from: shownFlight.value.departure, to: shownFlight.value.finished }] : []));
  followTrackSpans();
  followSpansOf(() => coveredDatasets.value.map(({ id, time_start, time_end }) => ({ id, from: time_start, to: time_end })));
}

/**
 * Tracks may be years older than all other data: the clock covers them only if there are no other data, or if a track
 * was chosen.
 */
function followTrackSpans(): void {
  const wanted = computed(() => {
    if (!chosenCurrents.value && model.shownPlans.value.length === 0) return gliderTracks.value;
    return chosenTrack.value ? [chosenTrack.value] : [];
  });
  followSpansOf(() => wanted.value.map(({ id, properties: { start, end } }) => ({ id: `track ${id}`, from: start, to: end })));

  let opened = false;
  effect(() => {
    const [first] = wanted.value;
    if (opened || !first) return;
    opened = true;
    untracked(() => setTime(opening.time_ms ?? firstHourOf(first.properties.start)));
  });
  effect(() => {
    const track = chosenTrack.value;
    if (track) untracked(() => setTime(firstHourOf(track.properties.start)));
  });
}

const firstHourOf = (time: string): number => Math.ceil(Date.parse(time) / hour_ms) * hour_ms;

/** Keeps the listed periods in the clock's range; an entry without times needs none. */
function followSpansOf(listed: () => { id: string; from: string | null; to: string | null }[]): void {
  let before: string[] = [];
  effect(() => {
    const now = listed();
    untracked(() => {
      for (const id of before) setSpan(id, undefined);
      before = now.map(({ id }) => id);
      for (const { id, from, to } of now) {
        if (from !== null && to !== null) setSpan(id, { start_ms: Date.parse(from), end_ms: Date.parse(to) });
      }
    });
  });
}

/**
 * Sets the clock at start: to now if the data cover it, otherwise to their first whole hour, and the departure to the
 * same; then to the time in the address, if there is one.
 */
function openAt(start_ms: number, end_ms: number): void {
  const now_ms = Math.floor(Date.now() / hour_ms) * hour_ms;
  const first_ms = Math.ceil(start_ms / hour_ms) * hour_ms;
  setTime(now_ms >= start_ms && now_ms <= end_ms ? now_ms : Math.min(first_ms, range.value.end_ms));
  if (draft.value.depart === '') fill({ depart: fieldOf(time_ms.value) });
  if (opening.time_ms !== undefined) setTime(opening.time_ms);
}

/** Deletes a dataset; returns why it failed, or undefined. */
export async function deleteDataset(id: string): Promise<string | undefined> {
  try {
    await api.deleteDataset(id);
  } catch (error) {
    return faultOf(error);
  }
  datasets.value = datasets.value?.filter((dataset) => dataset.id !== id);
  announce('The dataset was removed.');
  return undefined;
}
