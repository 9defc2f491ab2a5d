import type { VNode } from 'preact';
import type { Plan } from '../../contract/types';
import { allHolds_s, holdsOf } from '../../model/plan/holds';
import { withMoreLegs } from '../../model/plan/leg_trade';
import { duration, shortTime } from '../../model/time';
import { belowIce_m, belowIce_s } from '../../model/ice/under_ice';
import { showIceberg } from '../../model/ice/berg_card';
import { distance, energy, none } from '../../model/units';

interface Figure {
  title: string;
  text: (plan: Plan) => string;
  why?: (plan: Plan) => string; // tooltip
  value?: (plan: Plan) => number | null; // the value compared with that of the other plan
  difference?: (value: number) => string;
  iceberg?: (plan: Plan) => string | null; // the iceberg that the figure belongs to; a press shows it
}

const share = (value: number): string => `${(100 * value).toFixed(1)} %`;

function whyBelowIce(plan: Plan): string {
  if (!plan.surfacing) return 'The plan was made without sea ice data';
  return belowIce_m(plan) === null ? 'The plan is of an older version' : 'The stretches of the route with sea ice or icebergs above them';
}

const figures: Figure[] = [
  { title: 'Departure', text: (plan) => shortTime(Date.parse(plan.departure)) },
  { title: 'Arrival', text: (plan) => shortTime(Date.parse(plan.arrival)) },
  { title: 'Travel time', text: (plan) => duration(plan.travel_time_s), value: (plan) => plan.travel_time_s, difference: duration },
  { title: 'Distance', text: (plan) => distance(plan.distance_m), value: (plan) => plan.distance_m, difference: distance },
  {
    title: 'Holds',
    text: (plan) => (allHolds_s(plan) > 0 ? duration(allHolds_s(plan)) : none),
    why: (plan) => holdsOf(plan).join('\n'),
    value: allHolds_s,
    difference: duration,
  },
  {
    title: 'Nearest iceberg',
    text: (plan) => distance(plan.clearances.iceberg_m),
    value: (plan) => plan.clearances.iceberg_m,
    difference: distance,
    iceberg: (plan) => plan.clearances.iceberg_id ?? null,
  },
  { title: 'Nearest land', text: (plan) => distance(plan.clearances.land_m), value: (plan) => plan.clearances.land_m, difference: distance },
  { title: 'Above sea bed', text: (plan) => distance(plan.clearances.bottom_m), value: (plan) => plan.clearances.bottom_m, difference: distance },
  {
    title: 'Below ice',
    text: (plan) => distance(belowIce_m(plan)),
    why: whyBelowIce,
    value: belowIce_m,
    difference: distance,
  },
  {
    title: 'Time below ice',
    text: (plan) => (belowIce_s(plan) ? duration(belowIce_s(plan) ?? 0) : none),
    why: whyBelowIce,
    value: belowIce_s,
    difference: duration,
  },
  {
    title: 'Longest without a place to surface',
    text: ({ surfacing }) => (surfacing ? duration(surfacing.longest_without_surfacing_s) : none),
    why: () => 'Longest time between places where the vehicle may surface',
    value: ({ surfacing }) => surfacing?.longest_without_surfacing_s ?? null,
    difference: duration,
  },
  {
    title: 'Sea ice unknown',
    text: ({ surfacing }) => (surfacing && surfacing.unknown_ice_m > 0 ? distance(surfacing.unknown_ice_m) : none),
    why: () => 'Length of the route without data on sea ice',
    value: ({ surfacing }) => surfacing?.unknown_ice_m ?? null,
    difference: distance,
  },
  {
    title: 'Optimality gap',
    text: (plan) => (plan.optimality_gap === null ? none : share(plan.optimality_gap)),
    why: (plan) => plan.optimality_gap_reason,
  },
  { title: 'Energy', text: (plan) => energy(plan.energy_j), value: (plan) => plan.energy_j, difference: energy },
  {
    title: 'Battery used',
    text: (plan) => (plan.energy && plan.energy_j !== null ? share(plan.energy_j / plan.energy.usable_j) : none),
    why: () => 'Share of the usable energy, above the reserve',
  },
  {
    title: 'Iceberg encounters',
    text: (plan) => (typeof plan.iceberg_encounters === 'number' ? plan.iceberg_encounters.toFixed(2) : none),
    why: () => 'Expected encounters with unreported icebergs',
  },
  {
    title: 'With more legs',
    text: (plan) => {
      const more = withMoreLegs(plan);
      return more ? `${more.legs} legs, ${duration(more.gain_s)} less` : none;
    },
    why: () => 'What the fastest route would gain. The setting “Fewer legs for at most” says how much may be lost',
  },
  {
    title: 'Without the weight on encounters',
    text: ({ encounter_trade }) =>
      encounter_trade ? `${duration(encounter_trade.before.travel_time_s)}, ${encounter_trade.before.iceberg_encounters.toFixed(2)} encounters` : none,
    why: ({ encounter_trade }) => (encounter_trade ? `An expected encounter counts as ${duration(encounter_trade.weight_s)}` : ''),
  },
  {
    title: 'Travel time, p10–p90',
    text: ({ uncertainty }) => {
      const [p10, p90] = [uncertainty?.quantiles_s.p10 ?? null, uncertainty?.quantiles_s.p90 ?? null];
      if (!uncertainty) return none;
      return p10 === null || p90 === null ? `${uncertainty.arrived} of ${uncertainty.members} arrive` : `${duration(p10)} – ${duration(p90)}`;
    },
    why: ({ uncertainty }) => (uncertainty ? `${uncertainty.arrived} of ${uncertainty.members} members arrive` : ''),
  },
  {
    title: 'Chance to arrive in time',
    text: ({ uncertainty }) => (typeof uncertainty?.chance === 'number' ? `${Math.round(100 * uncertainty.chance)} %` : none),
    why: ({ uncertainty }) => (uncertainty?.arrive_before ? `Arrival by ${shortTime(Date.parse(uncertainty.arrive_before))}` : ''),
  },
];

/** The values of a plan; beside another plan with the differences to it, and dimmed while they are computed again. */
export function Figures({ plan, beside, pending = false }: { plan: Plan; beside?: Plan; pending?: boolean }): VNode {
  const shown = figures.filter(({ title, text }) => text(plan) !== none || !/^(Energy|Battery|Iceberg enc|Sea ice unk|Time below|With|Travel time, |Chance|Holds)/.test(title));
  return (
    <dl class={pending ? 'figures-grid pending' : 'figures-grid'} aria-busy={pending}>
      {shown.map((figure) => (
        <div key={figure.title} title={figure.why?.(plan)}>
          <dt>{figure.title}</dt>
          <dd>
            <FigureText figure={figure} plan={plan} />
            {beside && <Difference figure={figure} plan={plan} beside={beside} />}
          </dd>
        </div>
      ))}
    </dl>
  );
}

function FigureText({ figure, plan }: { figure: Figure; plan: Plan }): VNode {
  const berg_id = figure.iceberg?.(plan) ?? null;
  if (berg_id === null) return <>{figure.text(plan)}</>;
  return (
    <button type="button" class="link" title={`Show iceberg ${berg_id} on the map`} onClick={() => showIceberg(berg_id, plan)}>
      {figure.text(plan)} <small>{berg_id}</small>
    </button>
  );
}

function Difference({ figure, plan, beside }: { figure: Figure; plan: Plan; beside: Plan }): VNode | null {
  const [mine, other] = [figure.value?.(plan) ?? null, figure.value?.(beside) ?? null];
  if (mine === null || other === null || !figure.difference) return null;
  const text = figure.difference(Math.abs(mine - other));
  return <span class="difference">{text === figure.difference(0) ? '±0' : `${mine < other ? '−' : '+'}${text}`}</span>;
}
