import type { VNode } from 'preact';
import { recheck } from '../../actions/rechecking';
import type { Plan } from '../../contract/types';
import { reasonTitle } from '../../model/job';
import { may } from '../../model/login';
import { asSentence } from '../../model/page_words';
import { rechecks, staleness, type Recheck } from '../../model/stale';
import { duration, shortTime } from '../../model/time';
import { distance } from '../../model/units';
import { ask } from '../../model/view';
import { Icon } from '../common/icon';

/** Reports data that are newer than the plan, and evaluates the plan with them. */
export function StaleBox({ plan }: { plan: Plan }): VNode | null {
  const newer = staleness(plan);
  if (newer.length === 0) return null;
  const verdict = rechecks.value[plan.plan_id];
  return (
    <section class="warning-box" aria-label="Stale data">
      <h3><Icon name="clock" /> Made on older data</h3>
      <ul>{newer.map(({ id, kind, name, ingested }) => <li key={id}>newer {kind}: {name}, in since {shortTime(Date.parse(ingested))}</li>)}</ul>
      {verdict && <Result verdict={verdict} plan={plan} />}
      <button type="button" disabled={verdict?.state === 'pending' || !may('pilot')} onClick={() => void recheck(plan)}>
        <Icon name="refresh" /> {verdict?.state === 'pending' ? 'Checking …' : 'Re-check'}
      </button>
    </section>
  );
}

function Result({ verdict, plan }: { verdict: Recheck; plan: Plan }): VNode | null {
  switch (verdict.state) {
    case 'pending':
      return null;
    case 'failed':
      return <p class="fault" role="alert">{verdict.detail}</p>;
    case 'ok': {
      const more_s = verdict.plan.travel_time_s - plan.travel_time_s;
      return (
        <p role="status">
          <b>The route holds.</b> It takes {duration(verdict.plan.travel_time_s)} ({more_s < 0 ? '−' : '+'}{duration(Math.abs(more_s))}),
          nearest iceberg {distance(verdict.plan.clearances.iceberg_m)}.
        </p>
      );
    }
    case 'infeasible': {
      const { at, explanation, reason } = verdict.answer;
      return (
        <p class="fault" role="alert">
          <b>{reasonTitle(reason)}.</b> {asSentence(explanation)}{' '}
          <button type="button" class="link" onClick={() => ask({ do: 'centre', place: [at.lon, at.lat] })}>Show the place</button>
        </p>
      );
    }
  }
}
