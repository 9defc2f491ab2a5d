import type { VNode } from 'preact';
import type { Probe } from '../../api/types';
import { formatPosition } from '../../geo/coordinates';
import { directionTowards_deg } from '../../geo/vectors';
import { sizeTitle } from '../../model/icebergs';
import { probed } from '../../model/screen';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { course, depth, distance, none, speed } from '../../model/units';
import { IconButton } from '../common/icon';

/** Everything the server knows at the place last probed, with its sources. */
export function ProbeCard(): VNode | null {
  const probe = probed.value;
  if (!probe) return null;
  return (
    <section class="probe-card" aria-label="Probe" aria-live="polite">
      <h3>{formatPosition([probe.lon, probe.lat], settings.value.coordinates)}</h3>
      <IconButton icon="x" label="Close the probe" class="corner" onClick={() => { probed.value = undefined; }} />
      {probe.fault && <p class="fault">{probe.fault}</p>}
      {!probe.fault && !probe.answer && <p class="quiet">Asking the server …</p>}
      {probe.answer && <Answer answer={probe.answer} />}
    </section>
  );
}

function Answer({ answer }: { answer: Probe }): VNode {
  const { u_m_s, v_m_s, reason, dataset_name, time_before, time_after } = answer.currents;
  const flowing = u_m_s !== null && v_m_s !== null;
  const berg = answer.icebergs_within[0];
  return (
    <dl>
      <dt>Time</dt>
      <dd>{shortTime(Date.parse(answer.time))}</dd>
      <dt>Sea bed</dt>
      <dd>{answer.land ? 'land' : depth(answer.depth_m)}{answer.depth_reason && <small>{answer.depth_reason}</small>}</dd>
      <dt>Current</dt>
      <dd>
        {flowing ? `${speed(Math.hypot(u_m_s, v_m_s))} to ${course(directionTowards_deg(u_m_s, v_m_s))}` : none}
        {reason && <small>{reason}</small>}
        {dataset_name && <small>{dataset_name}{time_before && time_after ? `, ${shortTime(Date.parse(time_before))} to ${shortTime(Date.parse(time_after))}` : ''}</small>}
      </dd>
      <dt>Nearest ice</dt>
      <dd>
        {berg ? `${distance(berg.distance_m)}: ${berg.berg_id}` : 'none near'}
        {berg && <small>{sizeTitle(berg.size)}, seen {shortTime(Date.parse(berg.observed))}</small>}
      </dd>
    </dl>
  );
}
