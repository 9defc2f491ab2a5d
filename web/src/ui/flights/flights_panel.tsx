import type { VNode } from 'preact';
import { useEffect } from 'preact/hooks';
import { deleteSimulation } from '../../actions/deleting';
import { cancelFlight, fly, listSimulations, openSimulation } from '../../actions/simulating';
import type { SimulationSummary } from '../../contract/simulation_types';
import type { Plan } from '../../contract/types';
import { endedSo, endTitles } from '../../model/plan/flight';
import { stageTitle } from '../../model/job';
import { may } from '../../model/login';
import { startsUnderIce } from '../../model/plan/plans';
import { flightForm, flying, flyingFault, opened, shownFlight, stored, type FlightForm } from '../../model/plan/simulations';
import { shortTime } from '../../model/time';
import { Icon, IconButton } from '../common/icon';
import { RoleNote } from '../common/role_note';
import { FlightView } from './flight_view';
import { SimulationView } from './simulation_view';

/** Simulates the plan once or many times and shows the flights. */
export function FlightsPanel({ plan }: { plan: Plan }): VNode {
  useEffect(() => void listSimulations(plan.plan_id), [plan.plan_id]);
  const listed = stored.value[plan.plan_id];
  const open = opened.value?.plan_id === plan.plan_id ? opened.value : undefined;
  return (
    <div class="flights">
      <Ask plan={plan} />
      {flyingFault.value && <p class="fault" role="alert">{flyingFault.value}</p>}
      {listed === undefined && !flyingFault.value && <p class="quiet">Asking the server …</p>}
      {listed?.length === 0 && !flying.value && <p class="quiet">Not flown yet.</p>}
      {listed && listed.length > 0 && (
        <ul class="plan-list" aria-label="Simulations of this plan">
          {listed.map((one) => <Row key={one.simulation_id} one={one} chosen={one.simulation_id === open?.simulation_id} />)}
        </ul>
      )}
      {open && <SimulationView simulation={open} />}
      {open && shownFlight.value && <FlightView plan={plan} flight={shownFlight.value} />}
    </div>
  );
}

function Ask({ plan }: { plan: Plan }): VNode {
  const form = flightForm.value;
  const set = (part: Partial<FlightForm>): void => {
    flightForm.value = { ...form, ...part };
  };
  const submit = (event: Event): void => {
    event.preventDefault();
    void fly(plan);
  };
  const field = (name: 'runs' | 'current_error_m_s' | 'seed', label: string, unit?: string): VNode => (
    <div class="field">
      <label for={`flight-${name}`}>{label} {unit && <span class="unit">{unit}</span>}</label>
      <input id={`flight-${name}`} type="text" inputMode="decimal" autocomplete="off" value={form[name]} onInput={(event) => set({ [name]: event.currentTarget.value })} />
    </div>
  );
  const now = flying.value?.planId === plan.plan_id ? flying.value : undefined;
  return (
    <form class="flight-form" onSubmit={submit} aria-label="Simulate">
      <div class="flight-fields">{field('runs', 'Flights')}{field('current_error_m_s', 'Current error', 'm/s')}{field('seed', 'Seed')}</div>
      <label class="check">
        <input type="checkbox" checked={form.avoidance} onChange={(event) => set({ avoidance: event.currentTarget.checked })} />
        Obstacle avoidance on board
      </label>
      {startsUnderIce(plan) && (
        <p class="role-note" role="note"><Icon name="warning" size={13} /><span>This plan starts under ice, where the vehicle must not surface. The test bed launches only from open water and refuses this plan. Begin at a waypoint in open water, or plan without sea ice if there is none.</span></p>
      )}
      <RoleNote role="pilot" what="Simulating" />
      {now ? (
        <div class="job" role="status">
          <p class="job-line"><span class="job-stage">{stageTitle(now.status)}</span><span class="job-figures">{now.status?.progress ?? 0} %</span></p>
          <progress max={100} value={now.status?.progress ?? 0} aria-label="Simulation" />
          <button type="button" onClick={cancelFlight}>Cancel</button>
        </div>
      ) : (
        <button type="submit" disabled={flying.value !== undefined || !may('pilot')}><Icon name="play" /> Simulate this plan</button>
      )}
    </form>
  );
}

function Row({ one, chosen }: { one: SimulationSummary; chosen: boolean }): VNode {
  const { arrived, created, runs, simulation_id, avoidance } = one;
  return (
    <li class={chosen ? 'plan-row selected' : 'plan-row'}>
      <button type="button" class="plan-choose" aria-pressed={chosen} onClick={() => void openSimulation(simulation_id)}>
        <span class="plan-name">
          {runs === 1 ? '1 flight' : `${runs} flights`}
          {(['collided', 'grounded'] as const).map((end) => endedSo(one, end) > 0 && (
            <span class="badge bad" key={end}><Icon name="warning" size={12} /> {endedSo(one, end)} {endTitles[end]}</span>
          ))}
        </span>
        <span class="plan-figures">
          {arrived} arrived · {avoidance ? 'with' : 'without'} avoidance{created ? ` · ${shortTime(Date.parse(created))}` : ''}
        </span>
      </button>
      <IconButton icon="trash" label="Remove this simulation" class="row-remove" disabled={!may('pilot')} onClick={() => deleteSimulation(one)} />
    </li>
  );
}
