import { computed, effect, untracked } from '@preact/signals';
import { time_ms } from '../model/clock';
import { icebergChoice } from '../model/setup/iceberg_choice';
import { probed, probedDatasets, readOut } from '../model/probe';
import { isoOf } from '../model/time';
import { pointer } from '../model/view';
import type { Position } from '../contract/data_types';
import type { Probe } from '../contract/types';
import * as api from './client';

/** The data at a place at the clock's time, from the datasets that the map shows. */
const askOf = (place: Position): Promise<Probe> =>
  api.probe(place, isoOf(time_ms.value), { ...icebergChoice.value, datasets: probedDatasets.value });

let probes = 0;

/** Probes a place at the clock's time and shows the answer. */
export async function probeAt(place: Position): Promise<void> {
  const [lon, lat] = place;
  const number = ++probes;
  probed.value = { lon, lat, answer: undefined, fault: undefined };
  try {
    const answer = await askOf(place);
    if (number === probes) probed.value = { lon, lat, answer, fault: undefined };
  } catch (error) {
    if (number === probes) probed.value = { lon, lat, answer: undefined, fault: error instanceof Error ? error.message : String(error) };
  }
}

/** Pause between two requests for the pointer. */
const pause_ms = 100;

/** Keeps the read-out in step with the pointer and the clock, one request at a time. Call once. */
export function followPointer(): void {
  const wanted = computed(() => pointer.value && { place: pointer.value, time_ms: time_ms.value, datasets: probedDatasets.value });
  let isAsking = false;
  const read = async (): Promise<void> => {
    let asked: typeof wanted.value;
    for (let next = wanted.value; next && next !== asked; next = wanted.value) {
      asked = next;
      const answer = await askOf(next.place).catch(() => undefined);
      readOut.value = answer && { place: next.place, answer };
      await new Promise((done) => setTimeout(done, pause_ms));
    }
  };
  effect(() => {
    if (!wanted.value || isAsking) return;
    isAsking = true;
    void untracked(read).finally(() => {
      isAsking = false;
    });
  });
}
