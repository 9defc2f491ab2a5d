import type { ComponentChildren, VNode } from 'preact';
import type { PlanningKind, Position } from '../../contract/data_types';
import type { Probe } from '../../contract/types';
import { formatPosition } from '../../geo/coordinates';
import { openBergId } from '../../model/ice/berg_card';
import { icebergs } from '../../model/field';
import { chartInWords, drawnChart, eggAt, partInWords } from '../../model/ice/ice_chart';
import { sizeTitle } from '../../model/ice/icebergs';
import { bedInWords, currentInWords, iceInWords, isLeftOut, levelInWords, probed } from '../../model/probe';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { distance, none } from '../../model/units';
import { IconButton } from '../common/icon';

/** All data at the place probed last, with their sources. */
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
  const { reason, dataset_name, time_before, time_after } = answer.currents;
  const berg = answer.icebergs_within[0];
  const level = levelInWords(answer);
  return (
    <dl>
      <dt>Time</dt>
      <dd>{shortTime(Date.parse(answer.time))}</dd>
      <dt>Sea bed</dt>
      <Told of="bathymetry">{bedInWords(answer)}{answer.depth_reason && <small>{answer.depth_reason}</small>}</Told>
      <dt>Current</dt>
      <Told of="currents">
        {currentInWords(answer)}
        {reason && <small>{reason}</small>}
        {dataset_name && <Source name={dataset_name} from={time_before} to={time_after} />}
      </Told>
      {level && <dt>Water level</dt>}
      {level && (
        <dd>
          {level}
          {answer.water_level.station && <small>{answer.water_level.station}</small>}
          {answer.water_level.dataset_name && <Source name={answer.water_level.dataset_name} from={answer.water_level.time_before} to={answer.water_level.time_after} />}
        </dd>
      )}
      <dt>Sea ice</dt>
      <Told of="ice">
        {iceInWords(answer)}
        {answer.ice_concentration_reason && <small>{answer.ice_concentration_reason}</small>}
        {answer.ice.dataset_name && <Source name={answer.ice.dataset_name} from={answer.ice.time_before} to={answer.ice.time_after} />}
      </Told>
      <Egg place={[answer.lon, answer.lat]} />
      <dt>Nearest iceberg</dt>
      <Told of="icebergs">
        {berg ? <>{distance(berg.distance_m)}: <BergName id={berg.berg_id} /></> : 'none within 50 km'}
        {berg && <small>{sizeTitle(berg.size)}, seen {shortTime(Date.parse(berg.observed))}</small>}
      </Told>
    </dl>
  );
}

/**
 * The name of an iceberg. If the iceberg is in view, a click opens its card, which also shows the keel, instead of the
 * probe's.
 */
function BergName({ id }: { id: string }): VNode {
  if (!icebergs.value.some(({ properties }) => properties.berg_id === id)) return <>{id}</>;
  const openCard = (): void => {
    openBergId.value = id;
    probed.value = undefined;
  };
  return <button type="button" class="link" title="Show its size, keel, history and forecast" onClick={openCard}>{id}</button>;
}

/** The values of one kind of data, if plans of the set-up use it. */
function Told({ of, children }: { of: PlanningKind; children: ComponentChildren }): VNode {
  return isLeftOut(of) ? <dd>{none}<small>left out by the set-up</small></dd> : <dd>{children}</dd>;
}

/** The egg code of the chart there, as charts draw it, and in words. */
function Egg({ place }: { place: Position }): VNode | null {
  const chart = drawnChart.value;
  const egg = chart && eggAt(place);
  if (!egg) return null;
  const row = (kind: string): string[] => ['A', 'B', 'C'].flatMap((part) => egg.codes[`${kind}${part}`] ?? []);
  const rows = [egg.codes['CT'] ? [egg.codes['CT']] : [], row('C'), row('S'), row('F')].filter((codes) => codes.length > 0);
  return (
    <>
      <dt>Ice chart</dt>
      <dd>{egg.total ?? 'concentration not stated'}</dd>
      <dd class="whole-row">
        {rows.length > 0 && (
          <div class="egg" role="img" aria-label="Egg code">
            {rows.map((codes, i) => <span key={i}>{codes.join(' ')}</span>)}
          </div>
        )}
        {egg.parts.map((part, i) => <small key={i}>{partInWords(part)}</small>)}
        <small class={chart.isHeld ? undefined : 'caution'}>{chart.dataset_name}, {chartInWords(chart)}{chart.isHeld ? '' : ', too old for plans'}</small>
      </dd>
    </>
  );
}

/** The name of a dataset, and its two steps around the value. */
function Source({ name, from, to }: { name: string; from: string | null; to: string | null }): VNode {
  const [start, end] = [from, to].map((time) => (time === null ? undefined : shortTime(Date.parse(time))));
  const steps = start && end ? (start === end ? `, ${start}` : `, ${start} to ${end}`) : '';
  return <small>{name}{steps}</small>;
}
