import { signal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import type { VNode } from 'preact';
import { learnRequest } from '../../actions/plan_inputs';
import type { DatasetKind } from '../../contract/data_types';
import type { Plan } from '../../contract/types';
import { vehicles } from '../../model/datasets';
import { ofRank } from '../../model/messages';
import { baseline, baselineId, shownPlans, titleOf } from '../../model/plan/plans';
import { allHolds_s } from '../../model/plan/holds';
import { settingRows } from '../../model/plan/settings_difference';
import { requestOf } from '../../model/setup/requests';
import { shortTime } from '../../model/time';
import { belowIce_m, belowIce_s, closedWaypoints, deepestTurn_m, turnFigure } from '../../model/ice/under_ice';
import { distance, energy, none, shownDistance_m, shownEnergy_j, toStep } from '../../model/units';
import { Modal } from '../common/modal';
import { PlanKey } from '../common/plan_key';

/** How the values of a column are written; `greatest` of its values decides unit and decimals. */
interface Figure {
  text: (value: number, greatest: number) => string;
  /** What the text says, as a number: differences are those of what the table shows. */
  shown: (value: number, greatest: number) => number;
  difference?: (value: number, greatest: number) => string; // its text; if missing, as that of the value
}

interface Column extends Figure {
  title: string;
  value: (plan: Plan) => number | null;
}

const minute_s = 60;

/** To the minute, however long, because differences are: "35 h 04 min". */
const inMinutes = (seconds: number): string => {
  const minutes = Math.round(seconds / minute_s);
  return minutes < 60 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${String(minutes % 60).padStart(2, '0')} min`;
};
const percent: Figure = { text: (share) => `${(100 * share).toFixed(1)} %`, shown: (share) => toStep(share, 0.001) };
const chance: Figure = { text: (share) => `${Math.round(100 * share)} %`, shown: (share) => toStep(share, 0.01) };
const time: Figure = { text: inMinutes, shown: (seconds) => toStep(seconds, minute_s) };
const instant: Figure = {
  text: (at_s) => shortTime(1000 * at_s), shown: (at_s) => minute_s * Math.floor(at_s / minute_s), difference: inMinutes,
};
const count: Figure = { text: String, shown: (value) => value };
const length: Figure = { text: distance, shown: shownDistance_m };
const turn: Figure = { text: (value) => `${turnFigure(value)} m`, shown: Math.ceil };
const encounters: Figure = { text: (value) => value.toFixed(2), shown: (value) => toStep(value, 0.01) };

const columns: Column[] = [
  { title: 'Arrival', value: (plan) => Date.parse(plan.arrival) / 1000, ...instant },
  { title: 'Travel time', value: (plan) => plan.travel_time_s, ...time },
  { title: 'Holds', value: allHolds_s, ...time },
  { title: 'Distance', value: (plan) => plan.distance_m, ...length },
  { title: 'Below ice', value: belowIce_m, ...length },
  { title: 'Time below ice', value: belowIce_s, ...time },
  { title: 'Longest without a place to surface', value: ({ surfacing }) => surfacing?.longest_without_surfacing_s ?? null, ...time },
  { title: 'Waypoints without surfacing', value: closedWaypoints, ...count },
  { title: 'Deepest turn below ice', value: deepestTurn_m, ...turn },
  { title: 'Surfacings', value: ({ surfacing }) => surfacing?.planned.length ?? null, ...count },
  { title: 'Energy', value: (plan) => plan.energy_j, text: energy, shown: shownEnergy_j },
  { title: 'Battery used', value: ({ energy: battery, energy_j }) => (battery && energy_j !== null ? energy_j / battery.usable_j : null), ...percent },
  { title: 'Waypoints', value: (plan) => plan.waypoints.length, ...count },
  { title: 'Nearest iceberg', value: (plan) => plan.clearances.iceberg_m, ...length },
  { title: 'Nearest land', value: (plan) => plan.clearances.land_m, ...length },
  { title: 'Above sea bed', value: (plan) => plan.clearances.bottom_m, ...length },
  { title: '90 % arrive within', value: ({ uncertainty }) => uncertainty?.quantiles_s.p90 ?? null, ...time },
  { title: 'Chance to arrive in time', value: ({ uncertainty }) => uncertainty?.chance ?? null, ...chance },
  { title: 'Iceberg encounters', value: ({ iceberg_encounters }) => iceberg_encounters ?? null, ...encounters },
  { title: 'Optimality gap', value: (plan) => plan.optimality_gap, ...percent },
  { title: 'Dangers', value: (plan) => ofRank(plan, 'danger').length, ...count },
  { title: 'Cautions', value: (plan) => ofRank(plan, 'caution').length, ...count },
];

/** The difference of two values as they are shown, so that the figures of a column agree. */
function differenceOf({ text, shown, difference = text }: Column, value: number, base: number, greatest: number): string {
  const more = shown(value, greatest) - shown(base, greatest);
  const size = difference(Math.abs(more), greatest);
  return size === difference(0, greatest) ? '±0' : `${more < 0 ? '−' : '+'}${size}`;
}

/** Inputs and data of a plan as texts, which are compared. */
const inputs: { title: string; words: (plan: Plan) => string }[] = [
  { title: 'Departure', words: (plan) => shortTime(Date.parse(plan.departure)) },
  { title: 'Vehicle', words: ({ vehicle }) => vehicles.value.find(({ name }) => name === vehicle)?.title ?? vehicle },
  { title: 'Currents', words: (plan) => dataOf(plan, 'currents') },
  { title: 'Sea ice', words: (plan) => dataOf(plan, 'ice') },
  { title: 'Icebergs', words: (plan) => dataOf(plan, 'icebergs') },
];

const dataOf = ({ datasets }: Plan, kind: DatasetKind): string => datasets.filter((one) => one.kind === kind).map(({ name }) => name).join(', ') || none;

const order = signal<{ column: number; descending: boolean } | undefined>(undefined);

/** A table of the plans on the map, each cell with its difference to the baseline. */
export function CompareDialog(): VNode {
  const base = baseline.value;
  const rows = [...shownPlans.value];
  const by = order.value;
  const sorting = by && columns[by.column];
  if (sorting) {
    rows.sort((a, b) => ((sorting.value(a.plan) ?? Infinity) - (sorting.value(b.plan) ?? Infinity)) * (by.descending ? -1 : 1));
  }
  return (
    <Modal title="Compare plans" guide="compare" wide>
      <div class="scroll-box" tabIndex={0} role="region" aria-label="Comparison table">
        <table class="figures compare">
          <thead>
            <tr>
              <th scope="col">Plan</th>
              <th scope="col">Baseline</th>
              {columns.map(({ title }, i) => <Heading key={title} title={title} column={i} />)}
              {inputs.map(({ title }) => <th scope="col" class="words" key={title}>{title}</th>)}
            </tr>
          </thead>
          <tbody>
            {rows.map(({ plan, letter, style }) => (
              <tr key={plan.plan_id} class={plan === base ? 'selected' : ''}>
                <th scope="row"><PlanKey letter={letter} style={style} /> <span class="clamped" title={titleOf(plan)}>{titleOf(plan)}</span></th>
                <td>
                  <input
                    type="radio" name="baseline" checked={plan === base} aria-label={`Compare with plan ${letter}`}
                    onChange={() => {
                      baselineId.value = plan.plan_id;
                    }}
                  />
                </td>
                {columns.map((column) => <Cell key={column.title} column={column} plan={plan} base={base} />)}
                {inputs.map(({ title, words }) => (
                  <td key={title} class="words" title={words(plan)}>
                    {words(plan)}
                    {base && base !== plan && words(plan) !== words(base) && <span class="difference">differs</span>}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <DifferingSettings />
      <p class="hint">Small figures are the difference to the baseline; the table scrolls to the right, to what each plan was made on.</p>
    </Modal>
  );
}

/** The settings in which the plans differ, by the names of the set-up; the requests are asked of the server where they are not known. */
function DifferingSettings(): VNode | null {
  const compared = shownPlans.value;
  const ids = compared.map(({ plan }) => plan.plan_id).join(' ');
  const [learnt, setLearnt] = useState('');
  useEffect(() => {
    let wanted = true;
    void Promise.all(ids.split(' ').map(learnRequest)).then(() => {
      if (wanted) setLearnt(ids);
    });
    return () => {
      wanted = false;
    };
  }, [ids]);
  if (learnt !== ids) return <p class="quiet">Asking the server for the settings …</p>;
  const known = compared.flatMap((shown) => {
    const inputs = requestOf(shown.plan.plan_id);
    return inputs ? [{ ...shown, inputs }] : [];
  });
  const rows = settingRows(known.map(({ inputs }) => inputs));
  return (
    <section aria-label="Settings that differ">
      <h3>Settings that differ</h3>
      {known.length < compared.length && <p class="hint">The settings of {compared.length - known.length} of {compared.length} plans are not known.</p>}
      {rows.length === 0 ? <p class="quiet">None but those above.</p> : (
        <div class="scroll-box" tabIndex={0} role="region" aria-label="Settings that differ, a row each">
          <table class="figures differing">
            <thead>
              <tr>
                <th scope="col">Setting</th>
                {known.map(({ plan, letter, style }) => <th scope="col" key={plan.plan_id} title={titleOf(plan)}><PlanKey letter={letter} style={style} /></th>)}
              </tr>
            </thead>
            <tbody>
              {rows.map(({ name, label, values }) => (
                <tr key={name}><th scope="row">{label}</th>{values.map((value, i) => <td key={known[i]?.plan.plan_id ?? i}>{value}</td>)}</tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </section>
  );
}

function Heading({ title, column }: { title: string; column: number }): VNode {
  const now = order.value?.column === column ? order.value : undefined;
  const next = (): void => {
    order.value = { column, descending: now ? !now.descending : false };
  };
  return (
    <th scope="col" aria-sort={now ? (now.descending ? 'descending' : 'ascending') : 'none'}>
      <button type="button" class="sort" onClick={next}>{title}{now ? (now.descending ? ' ↓' : ' ↑') : ''}</button>
    </th>
  );
}

function Cell({ column, plan, base }: { column: Column; plan: Plan; base: Plan | undefined }): VNode {
  const value = column.value(plan);
  const other = base && base !== plan ? column.value(base) : null;
  const greatest = Math.max(...shownPlans.value.map((shown) => Math.abs(column.value(shown.plan) ?? 0)));
  return (
    <td>
      {value === null ? none : column.text(value, greatest)}
      {value !== null && other !== null && <span class="difference">{differenceOf(column, value, other, greatest)}</span>}
    </td>
  );
}
