import type { VNode } from 'preact';
import type { GliderTrackFeature } from '../../contract/data_types';
import { directionTowards_deg } from '../../geo/vectors';
import { shortTime } from '../../model/time';
import { course, depth, speed } from '../../model/units';

/** Period, dive depth and mean current of a glider track. */
export function TrackFigures({ track: { properties } }: { track: GliderTrackFeature }): VNode {
  const { current_frame, deepest_m, end, mean_east_m_s: east, mean_north_m_s: north, start } = properties;
  return (
    <>
      <span>{shortTime(Date.parse(start))} – {shortTime(Date.parse(end))}</span>
      {deepest_m !== null && <span>to {depth(deepest_m)}</span>}
      {current_frame === 'vehicle' && <span>currents in the vehicle’s own axes: import its files again</span>}
      {current_frame !== 'vehicle' && east !== null && north !== null && <span>mean current {speed(Math.hypot(east, north))} to {course(directionTowards_deg(east, north))}</span>}
    </>
  );
}
