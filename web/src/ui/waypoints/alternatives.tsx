import type { VNode } from 'preact';
import type { Alternative, Plan } from '../../contract/types';
import { formatPosition } from '../../geo/coordinates';
import { alternativesTo, bestOf, laterThan, showBesideAlternatives, type StoredAlternative } from '../../model/plan/alternatives';
import { guidePages } from '../../model/guide_pages';
import { placeOf, showMessage } from '../../model/messages';
import { asSentence } from '../../model/page_words';
import { select, shownPlans, titleOf } from '../../model/plan/plans';
import { announce, dialog } from '../../model/screen';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { distance } from '../../model/units';
import { GuideLink } from '../common/guide_link';
import { Icon } from '../common/icon';
import { PlanKey } from '../common/plan_key';
import { ToldBadge } from '../common/told_badge';

/** The alternatives to a plan; of an alternative, the plan that it belongs to. */
export function Alternatives({ plan }: { plan: Plan }): VNode | null {
  const others = alternativesTo(plan);
  const belongsTo = bestOf(plan);
  if (belongsTo) return <Belongs plan={plan} {...belongsTo} />;
  if (others.length === 0) return null;
  return (
    <section class="alternatives" aria-label="Alternatives">
      <h3>Alternatives <GuideLink page={guidePages.alternatives} /></h3>
      <ul>
        {others.map((other) => <Row key={other.plan.plan_id} best={plan} other={other} />)}
      </ul>
      <CompareButton best={plan} />
    </section>
  );
}

function Row({ best, other: { alternative, plan } }: { best: Plan; other: StoredAlternative }): VNode {
  return (
    <li>
      <p class="alternative-head">
        <Key plan={plan} /> <b>{laterThan(best, alternative)}</b>
        <ShowButton plan={plan} />
      </p>
      <p class="plan-figures">
        {distance(alternative.distance_m)} · arrives {shortTime(Date.parse(alternative.arrival))}
        {' '}<ToldBadge plan={plan} rank="danger" /> <ToldBadge plan={plan} rank="caution" />
      </p>
      <Reason alternative={alternative} />
    </li>
  );
}

function Belongs({ plan, best, alternative }: { plan: Plan; best: Plan; alternative: Alternative }): VNode {
  return (
    <section class="alternatives" aria-label="Alternatives">
      <h3>Alternative to <span class="clamped" title={titleOf(best)}>{titleOf(best)}</span> <GuideLink page={guidePages.alternatives} /></h3>
      <p class="alternative-head">
        <Key plan={plan} /> <b>{laterThan(best, alternative)}</b>
        <ShowButton plan={best} />
      </p>
      <Reason alternative={alternative} />
      <CompareButton best={best} />
    </section>
  );
}

/** The key of a plan that is on the map. */
function Key({ plan }: { plan: Plan }): VNode | null {
  const shown = shownPlans.value.find((candidate) => candidate.plan === plan);
  return shown ? <PlanKey letter={shown.letter} style={shown.style} /> : null;
}

/** The obstacle that an alternative leads around, with a button that shows it on the map. */
function Reason({ alternative: { message } }: { alternative: Alternative }): VNode {
  const place = placeOf(message);
  return (
    <p>
      {asSentence(message.text)}
      {place && (
        <button type="button" class="link place" aria-label={`Show ${formatPosition(place, settings.value.coordinates)} on the map`} onClick={() => showMessage(message)}>
          Show the place
        </button>
      )}
    </p>
  );
}

function ShowButton({ plan }: { plan: Plan }): VNode {
  const show = (): void => {
    select(plan.plan_id);
    announce(`${titleOf(plan)} is selected.`);
  };
  return <button type="button" aria-label={`Show ${titleOf(plan)}`} onClick={show}>Show</button>;
}

function CompareButton({ best }: { best: Plan }): VNode {
  const compare = (): void => {
    showBesideAlternatives(best);
    dialog.value = 'compare';
  };
  return <button type="button" aria-label={`Compare ${titleOf(best)} with its alternatives`} onClick={compare}><Icon name="compare" /> Compare</button>;
}
