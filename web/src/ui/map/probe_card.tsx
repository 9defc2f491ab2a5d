import type { VNode } from 'preact';
import type { Probe } from '../../api/types';
import { formatPosition } from '../../geo/coordinates';
import { directionTowards_deg } from '../../geo/vectors';
import { sizeTitle } from '../../model/icebergs';
import { probed } from '../../model/screen';
import { seaIceInWords } from '../../model/sea_ice';
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
        {dataset_name && <Source name={dataset_name} from={time_before} to={time_after} />}
      </dd>
      <dt>Sea ice</dt>
      <dd>
        {seaIceInWords(answer.ice_concentration, answer.ice.thickness_m)}
        {answer.ice_concentration_reason && <small>{answer.ice_concentration_reason}</small>}
        {answer.ice.dataset_name && <Source name={answer.ice.dataset_name} from={answer.ice.time_before} to={answer.ice.time_after} />}
      </dd>
      <dt>Nearest iceberg</dt>
      <dd>
        {berg ? `${distance(berg.distance_m)}: ${berg.berg_id}` : 'none within 50 km'}
        {berg && <small>{sizeTitle(berg.size)}, seen {shortTime(Date.parse(berg.observed))}</small>}
      </dd>
    </dl>
  );
}

/** A dataset, and the steps of it that the value lies between. */
function Source({ name, from, to }: { name: string; from: string | null; to: string | null }): VNode {
  const [start, end] = [from, to].map((time) => (time === null ? undefined : shortTime(Date.parse(time))));
  const steps = start && end ? (start === end ? `, ${start}` : `, ${start} to ${end}`) : '';
  return <small>{name}{steps}</small>;
}
