import { effect, untracked } from '@preact/signals';
import { bergHistory, openBerg, openBergId } from '../model/ice/berg_card';
import * as api from './client';
import { Latest } from './latest';

/** Keeps the history of the iceberg whose card is open. Call once. */
export function followBergHistory(): void {
  const latest = new Latest();
  effect(() => {
    const berg_id = openBergId.value;
    bergHistory.value = undefined;
    if (berg_id === undefined) return;
    untracked(() => {
      const seenOnce = openBerg.value && { berg_id, sightings: 1, from: openBerg.value.properties.observed };
      latest.run(
        (signal) => api.icebergTracks(berg_id, signal),
        ({ features: [track] }) => {
          bergHistory.value = track?.properties ?? seenOnce;
        },
        () => undefined,
      );
    });
  });
}
