import type { VNode } from 'preact';
import { formatPosition } from '../../geo/coordinates';
import { chosenSeaIce } from '../../model/datasets';
import { sizeTitle } from '../../model/ice/icebergs';
import { bedInWords, currentInWords, iceInWords, isLeftOut, readOut } from '../../model/probe';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { distance, none } from '../../model/units';
import { hoveredTrack } from '../../model/tracks';
import { hoveredBerg, pointer } from '../../model/view';
import { TrackFigures } from '../common/track_figures';

/**
 * Position, depth, current and sea ice under the pointer, from the probe; the sighting of a berg or the track of a
 * glider under the pointer.
 */
export function Readout(): VNode | null {
  const place = pointer.value;
  if (!place) return null;
  const berg = hoveredBerg.value?.properties;
  if (berg) {
    return (
      <div class="readout">
        <b>{berg.berg_id}</b>
        <span>{sizeTitle(berg.size)}{berg.length_m !== null ? `, ${distance(berg.length_m)} long` : ''}</span>
        <span>seen {shortTime(Date.parse(berg.observed))}</span>
        {berg.position_uncertainty_m !== null && <span>±{distance(berg.position_uncertainty_m)}</span>}
      </div>
    );
  }
  const track = hoveredTrack.value;
  if (track) {
    return (
      <div class="readout">
        <b>{track.properties.glider}</b>
        <TrackFigures track={track} />
      </div>
    );
  }
  const read = readOut.value;
  const answer = read?.answer;
  return (
    <div class={read?.place === place ? 'readout' : 'readout late'}>
      <span class="figure">{formatPosition(place, settings.value.coordinates)}</span>
      {!isLeftOut('bathymetry') && <span>{answer?.land ? '' : 'depth '}{answer ? bedInWords(answer) : none}</span>}
      {!isLeftOut('currents') && <span>current {answer ? currentInWords(answer) : none}</span>}
      {chosenSeaIce.value && <span>sea ice {answer ? iceInWords(answer) : none}</span>}
    </div>
  );
}
