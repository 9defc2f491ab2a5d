import type { VNode } from 'preact';
import { deletePlan } from '../../api/session';
import type { Plan } from '../../api/types';
import { time_ms } from '../../model/clock';
import { edit } from '../../model/draft';
import { editablePosition } from '../../geo/coordinates';
import { routeOf, selectedShown, titleOf } from '../../model/plans';
import { dialog, leftTab } from '../../model/screen';
import { duration, fieldOf, shortTime } from '../../model/time';
import { distance, energy } from '../../model/units';
import { ask } from '../../model/view';
import { Icon, IconButton } from '../common/icon';
import { PlanKey } from '../common/plan_key';
import { WaypointTable } from './waypoint_table';

/** What was got: the selected plan in figures, its warnings and its waypoints. */
export function WaypointsPanel(): VNode {
  const shown = selectedShown.value;
  if (!shown) {
    return (
      <div class="quiet">
        <h2>Waypoints</h2>
        <p>No plan is selected. Its waypoints appear here, with times, courses and depths.</p>
        <ol>
          <li>Press the cross-hair beside <b>Start</b> and click the map, or type a position; the same for <b>Goal</b>.</li>
          <li>Check the departure and the vehicle.</li>
          <li>Press <b>Plan route</b>.</li>
        </ol>
      </div>
    );
  }
  const { plan, letter, style } = shown;
  return (
    <div class="result">
      <div class="result-head">
        <h2><PlanKey letter={letter} style={style} /> {titleOf(plan)}</h2>
        <IconButton icon="maximize" label="Fit the map to this plan" onClick={() => ask({ do: 'fit', places: routeOf(plan) })} />
        <IconButton icon="refresh" label="Copy start, goal and departure into the set-up" onClick={() => reuse(plan)} />
        <IconButton icon="trash" label="Delete this plan" onClick={() => confirmDelete(plan)} />
      </div>
      <Figures plan={plan} />
      <Warnings warnings={plan.warnings} />
      <button
        type="button" class="export-button"
        onClick={() => {
          dialog.value = 'export';
        }}
      >
        <Icon name="download" /> Export mission
      </button>
      <WaypointTable plan={plan} at_ms={time_ms.value} />
      <details class="provenance">
        <summary>Computed from</summary>
        <ul>
          {plan.datasets.map(({ id, kind, name, sha256 }) => (
            <li key={id}>{kind}: {name} <code title={sha256}>{sha256.slice(0, 8)}</code></li>
          ))}
        </ul>
        <p>
          {plan.vehicle}, method {plan.method}; {plan.search.vertices.toLocaleString('en')} vertices,{' '}
          {plan.search.expansions.toLocaleString('en')} expansions in {plan.search.seconds.toFixed(1)} s.
        </p>
      </details>
    </div>
  );
}

function Figures({ plan }: { plan: Plan }): VNode {
  const gap = plan.optimality_gap === null ? '–' : `${(100 * plan.optimality_gap).toFixed(1)} %`;
  const figures: [string, string, string?][] = [
    ['Departure', shortTime(Date.parse(plan.departure))],
    ['Arrival', shortTime(Date.parse(plan.arrival))],
    ['Travel time', duration(plan.travel_time_s)],
    ['Distance', distance(plan.distance_m)],
    ['Nearest ice', distance(plan.clearances.iceberg_m)],
    ['Nearest land', distance(plan.clearances.land_m)],
    ['Above sea bed', distance(plan.clearances.bottom_m)],
    ['Optimality gap', gap, plan.optimality_gap_reason],
    ...(plan.energy_j === null ? [] : ([['Energy', energy(plan.energy_j)]] as [string, string][])),
  ];
  return (
    <dl class="figures-grid">
      {figures.map(([title, text, why]) => (
        <div key={title} title={why}>
          <dt>{title}</dt>
          <dd>{text}</dd>
        </div>
      ))}
    </dl>
  );
}

export function Warnings({ warnings }: { warnings: string[] }): VNode | null {
  if (warnings.length === 0) return null;
  return (
    <section class="warning-box" aria-label="Warnings">
      <h3><Icon name="warning" /> {warnings.length === 1 ? '1 warning' : `${warnings.length} warnings`}</h3>
      <ul>{warnings.map((text) => <li key={text}>{text}</li>)}</ul>
    </section>
  );
}

function reuse(plan: Plan): void {
  const [from, to] = [plan.waypoints[0], plan.waypoints.at(-1)];
  if (!from || !to) return;
  edit({
    from: editablePosition([from.lon, from.lat]),
    to: editablePosition([to.lon, to.lat]),
    depart: fieldOf(Date.parse(plan.departure)),
  });
  leftTab.value = 'setup';
}

function confirmDelete(plan: Plan): void {
  if (window.confirm(`Delete ${titleOf(plan)} for good?`)) void deletePlan(plan.plan_id);
}
