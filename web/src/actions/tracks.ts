import { effect, untracked } from '@preact/signals';
import { ofKind } from '../model/datasets';
import { visible } from '../model/layers';
import { gliderTracks } from '../model/tracks';
import * as api from './client';
import { Latest } from './latest';

/** Keeps the tracks of gliders in step with the store, while they are shown. Call once. */
export function followTracks(): void {
  const latest = new Latest();
  let known = '';
  effect(() => {
    const now = ofKind('glider-tracks').map(({ id, ingested }) => id + ingested).join();
    if (now === known || !visible.value.tracks) return;
    known = now;
    untracked(() => {
      if (now === '') {
        latest.cancel();
        gliderTracks.value = [];
        return;
      }
      latest.run(
        (signal) => api.gliderTracks(signal),
        ({ features }) => {
          gliderTracks.value = features;
        },
        () => {
          known = '';
        },
      );
    });
  });
}
