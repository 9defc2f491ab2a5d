import { signal } from '@preact/signals';
import type { VNode } from 'preact';
import type { Plan } from '../../contract/types';
import { plans, select, selectedId, show, shown, shownPlans, titleOf } from '../../model/plan/plans';
import { routeEdit } from '../../model/plan/route_edit';
import { dialog } from '../../model/screen';
import { staleness } from '../../model/stale';
import { duration, shortTime } from '../../model/time';
import { distance } from '../../model/units';
import { Icon } from '../common/icon';
import { PlanKey } from '../common/plan_key';
import { ToldBadge } from '../common/told_badge';

/** With this many plans or more the list has a search field. */
const many = 10;
const wanted = signal('');

/** The list of all stored plans; ticked ones are on the map and in the comparison. */
export function PlansPanel(): VNode {
  if (plans.value.length === 0) {
    return <p class="quiet">No plans yet. Give a start and a goal under <b>Set-up</b> and press <b>Plan route</b>.</p>;
  }
  const words = wanted.value.trim().toLowerCase();
  const found = plans.value.filter((plan) => words === '' || titleOf(plan).toLowerCase().includes(words) || shown.value.includes(plan.plan_id));
  return (
    <div class="plans">
      {plans.value.length >= many && (
        <div class="field">
          <label for="find-plan">Find a plan <span class="unit">{found.length} of {plans.value.length}</span></label>
          <input id="find-plan" type="text" value={wanted.value} placeholder="part of its name" autocomplete="off" onInput={(event) => { wanted.value = event.currentTarget.value; }} />
        </div>
      )}
      <ul class="plan-list">
        {found.map((plan) => <PlanRow key={plan.plan_id} plan={plan} />)}
      </ul>
      <button
        type="button" class="compare-plans" disabled={shownPlans.value.length < 2}
        onClick={() => {
          dialog.value = 'compare';
        }}
      >
        <Icon name="compare" /> Compare {shownPlans.value.length > 1 ? `${shownPlans.value.length} plans` : 'plans'}
      </button>
      {shownPlans.value.length < 2 && <p class="hint">Tick two or more plans to compare them.</p>}
    </div>
  );
}

function PlanRow({ plan }: { plan: Plan }): VNode {
  const id = plan.plan_id;
  const on = shown.value.includes(id);
  const key = shownPlans.value.find((candidate) => candidate.plan.plan_id === id);
  return (
    <li class={selectedId.value === id ? 'plan-row selected' : 'plan-row'}>
      <label class="tick">
        <input type="checkbox" checked={on} onChange={(event) => show(id, event.currentTarget.checked)} aria-label={`Show ${titleOf(plan)} on the map`} />
      </label>
      <button type="button" class="plan-choose" aria-pressed={selectedId.value === id} onClick={() => select(id)}>
        <span class="plan-name">
          {key && <PlanKey letter={key.letter} style={key.style} />} <span class="clamped" title={titleOf(plan)}>{titleOf(plan)}</span>
          {staleness(plan).length > 0 && <span class="badge"><Icon name="clock" size={12} /> stale data</span>}
          {routeEdit.value?.origin.plan_id === id && <span class="badge"><Icon name="edit" size={12} /> under change</span>}
          <ToldBadge plan={plan} rank="danger" />
          <ToldBadge plan={plan} rank="caution" />
        </span>
        <span class="plan-figures">
          {duration(plan.travel_time_s)} · {distance(plan.distance_m)} · from {shortTime(Date.parse(plan.departure))}
          {typeof plan.uncertainty?.chance === 'number' && ` · ${Math.round(100 * plan.uncertainty.chance)} % chance to arrive in time`}
        </span>
      </button>
    </li>
  );
}
