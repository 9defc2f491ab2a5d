import type { VNode } from 'preact';
import { formatPosition } from '../../geo/coordinates';
import { directionTowards_deg } from '../../geo/vectors';
import { chosenSeaIce } from '../../model/datasets';
import { readingAt } from '../../model/field';
import { sizeTitle } from '../../model/icebergs';
import { seaIceInWords } from '../../model/sea_ice';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { course, depth, distance, none, speed } from '../../model/units';
import { hoveredTrack } from '../../model/tracks';
import { hoveredBerg, pointer } from '../../model/view';
import { TrackFigures } from '../common/track_figures';

/** Position, depth, current and sea ice under the pointer; a berg's sighting or a glider's track when it points at one. */
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
  const reading = readingAt(place);
  const { depth_m, east_m_s, north_m_s, concentration, thickness_m } = reading;
  const flowing = east_m_s !== undefined && north_m_s !== undefined;
  return (
    <div class="readout">
      <span class="figure">{formatPosition(place, settings.value.coordinates)}</span>
      <span>{depth_m !== undefined && depth_m <= 0 ? 'land' : `depth ${depth(depth_m)}`}</span>
      <span>
        current {flowing ? `${speed(Math.hypot(east_m_s, north_m_s))} to ${course(directionTowards_deg(east_m_s, north_m_s))}` : none}
      </span>
      {chosenSeaIce.value && <span>sea ice {seaIceInWords(concentration, thickness_m)}</span>}
    </div>
  );
}
