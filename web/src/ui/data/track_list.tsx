import type { VNode } from 'preact';
import type { GliderTrackFeature } from '../../contract/data_types';
import { visible } from '../../model/layers';
import { chosenTrackId, gliderTracks, placesOf } from '../../model/tracks';
import { ask } from '../../model/view';
import { TrackFigures } from '../common/track_figures';

/** The tracks of a dataset with their values; choosing one moves the map and the clock to it. */
export function TrackList({ dataset, name }: { dataset: string; name: string }): VNode | null {
  const tracks = gliderTracks.value.filter(({ properties }) => properties.dataset_id === dataset);
  if (tracks.length === 0) return null;
  return (
    <ul class="track-list" aria-label={`Tracks of ${name}`}>
      {tracks.map((track) => <Row key={track.id} track={track} />)}
    </ul>
  );
}

function Row({ track }: { track: GliderTrackFeature }): VNode {
  const chosen = chosenTrackId.value === track.id;
  const choose = (): void => {
    chosenTrackId.value = chosen ? undefined : track.id;
    if (chosen) return;
    visible.value = { ...visible.value, tracks: true };
    ask({ do: 'fit', places: placesOf(track) });
  };
  return (
    <li class="dataset-figures">
      <button type="button" class="link" aria-pressed={chosen} onClick={choose}>{track.properties.glider}</button>
      <TrackFigures track={track} />
    </li>
  );
}
