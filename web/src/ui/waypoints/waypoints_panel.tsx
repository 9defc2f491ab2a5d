import type { VNode } from 'preact';
import { briefAddress } from '../../actions/client';
import { deletePlan } from '../../actions/deleting';
import { editCopy } from '../../actions/plan_inputs';
import type { Plan } from '../../contract/types';
import { edit, emptyDraft } from '../../model/setup/draft';
import { editablePosition } from '../../geo/coordinates';
import { may } from '../../model/login';
import { routeOf, selectedShown, titleOf } from '../../model/plan/plans';
import { safePlacesOf } from '../../model/plan/export_options';
import { openEdit } from '../../model/plan/route_edit';
import { dialog, leftTab, rightTab } from '../../model/screen';
import { fieldOf } from '../../model/time';
import { ask } from '../../model/view';
import { Icon, IconButton } from '../common/icon';
import { later } from '../common/later';
import { Messages } from '../common/messages';
import { PlanKey } from '../common/plan_key';
import { RoleNote } from '../common/role_note';
import { Alternatives } from './alternatives';
import { Figures } from './figures';
import { StaleBox } from './stale_box';
import { WaypointTable } from './waypoint_table';

const EditPanel = later(async () => (await import('./edit_panel')).EditPanel);
const FlightsPanel = later(async () => (await import('../flights/flights_panel')).FlightsPanel);
const Departures = later(async () => (await import('../charts/departures')).Departures);
const Profile = later(async () => (await import('../charts/profile')).Profile);

/** The result: the values of the selected plan, its messages and its waypoints. */
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
  if (openEdit.value) return <EditPanel edit={openEdit.value} shown={shown} />;
  return (
    <div class="result">
      <div class="result-head">
        <h2><PlanKey letter={letter} style={style} /> <span class="clamped" title={titleOf(plan)}>{titleOf(plan)}</span></h2>
        <IconButton icon="maximize" label="Fit the map to this plan" onClick={() => ask({ do: 'fit', places: routeOf(plan) })} />
        <IconButton icon="trash" label="Delete this plan" disabled={!may('pilot')} onClick={() => deletePlan(plan)} />
      </div>
      <StaleBox plan={plan} />
      <Figures plan={plan} />
      <Messages of={plan} />
      <Alternatives plan={plan} />
      <RoleNote role="pilot" what="Changing a plan" />
      <div class="edit-save">
        <button type="button" disabled={!may('pilot')} onClick={() => void editCopy(plan)}><Icon name="edit" /> Edit copy</button>
        <button type="button" title="Copy start, goal and departure into the set-up" onClick={() => reuse(plan)}><Icon name="refresh" /> Use these settings</button>
        <a class="button" href={briefAddress(plan.plan_id, safePlacesOf(plan.plan_id))} download=""><Icon name="download" /> Brief</a>
        <button
          type="button" class="export-button"
          onClick={() => {
            dialog.value = 'export';
          }}
        >
          <Icon name="download" /> Export mission
        </button>
      </div>
      <Tabs plan={plan} />
      {rightTab.value === 'departures' && plan.departures ? (
        <Departures key={plan.plan_id} plan={plan} departures={plan.departures} />
      ) : rightTab.value === 'profile' ? (
        <Profile plan={plan} />
      ) : rightTab.value === 'flights' ? (
        <FlightsPanel plan={plan} />
      ) : (
        <WaypointTable plan={plan} />
      )}
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

function Tabs({ plan }: { plan: Plan }): VNode {
  const tabs = [['waypoints', 'Waypoints'], ['profile', 'Profile'], ...(plan.departures ? [['departures', 'Departures'] as const] : []), ['flights', 'Flights']] as const;
  const shown = tabs.some(([name]) => name === rightTab.value) ? rightTab.value : 'waypoints';
  return (
    <div class="tabs" role="group" aria-label="Plan in detail">
      {tabs.map(([name, title]) => (
        <button type="button" key={name} aria-pressed={shown === name} onClick={() => { rightTab.value = name; }}>{title}</button>
      ))}
    </div>
  );
}

function reuse(plan: Plan): void {
  const [from, to] = [plan.waypoints[0], plan.waypoints.at(-1)];
  if (!from || !to) return;
  edit({
    from: editablePosition([from.lon, from.lat]),
    to: editablePosition([to.lon, to.lat]),
    goals_file: emptyDraft.goals_file,
    route_name: emptyDraft.route_name,
    depart: fieldOf(Date.parse(plan.departure)),
  });
  leftTab.value = 'setup';
}
