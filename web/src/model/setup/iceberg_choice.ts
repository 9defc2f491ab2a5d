import { computed } from '@preact/signals';
import type { Dataset } from '../../contract/data_types';
import type { Plan } from '../../contract/types';
import { time_ms } from '../clock';
import { severalIn } from './data_choice';
import { ofKind } from '../datasets';
import { draft, numberIn } from './draft';
import { shownPlans } from '../plan/plans';
import { oldestThatCounts_ms, sighting_days } from './sighting_age';
import { isoOf, parseTime } from '../time';

/** The icebergs that the map shows: datasets (default all) and greatest age of sightings. */
export interface IcebergChoice {
  datasets: string[] | undefined;
  max_sighting_age_days: number | undefined; // undefined: the server's default
  // ages are counted at this departure once the clock has passed it; undefined: at the clock's time
  departure: string | undefined;
}

type Wish = Pick<IcebergChoice, 'datasets' | 'max_sighting_age_days'>;

/** The icebergs of the set-up; undefined: none. */
const draftWish = computed<Wish | undefined>(() => {
  const wish = draft.value.icebergs;
  if (wish === 'none') return undefined;
  const named = wish === 'newest' ? undefined : (severalIn(wish) ?? [wish]);
  if (named?.length === 0) return undefined; // a choice of several, none of them ticked yet
  const days = numberIn(draft.value.max_sighting_age_days);
  return { datasets: named, max_sighting_age_days: days !== undefined && days >= 0 && days <= 30 ? days : undefined };
});

const idsUnderWay = computed(() =>
  shownPlans.value
    .filter(({ plan }) => Date.parse(plan.departure) <= time_ms.value && time_ms.value <= Date.parse(plan.arrival))
    .map(({ plan }) => plan.plan_id)
    .join(' '),
);

/** Plans on the map that are under way at the clock's time and obey icebergs; the map shows their icebergs. */
const underWay = computed<Plan[]>(() => {
  const ids = idsUnderWay.value.split(' ');
  return shownPlans.value.map(({ plan }) => plan).filter((plan) => ids.includes(plan.plan_id) && bergsOf(plan).length > 0);
});

const bergsOf = (plan: Plan): string[] => plan.datasets.filter(({ kind }) => kind === 'icebergs').map(({ id }) => id);

/** The time at which the ages of its sightings were counted. */
export const countedAt_ms = ({ departure, sightings }: Plan): number => Math.min(Date.parse(departure), sightings ? Date.parse(sightings.as_of) : Infinity);

/** The icebergs of the set-up and of the plans under way; undefined: none. */
export const icebergChoice = computed<IcebergChoice | undefined>(() => {
  const wish = draftWish.value;
  const plans = underWay.value;
  if (plans.length === 0) return wish && { ...wish, departure: undefined };
  const obeyed = plans.flatMap(bergsOf);
  const datasets = wish && !wish.datasets ? undefined : [...new Set([...(wish?.datasets ?? []), ...obeyed])];
  const ages = plans.map(({ sightings }) => sightings?.max_age_days ?? sighting_days);
  const longest = Math.max(...ages, wish ? (wish.max_sighting_age_days ?? sighting_days) : 0);
  const departure = isoOf(Math.min(...plans.map(countedAt_ms)));
  return { datasets, max_sighting_age_days: longest === sighting_days ? undefined : longest, departure };
});

/** The datasets of the shown icebergs. */
export const shownIcebergs = computed<Dataset[]>(() => {
  const choice = icebergChoice.value;
  return choice ? ofKind('icebergs').filter(({ id }) => !choice.datasets || choice.datasets.includes(id)) : [];
});

/** The time up to which sightings count. Undefined: up to the clock's time, as always while a plan is under way. */
export const knownAt_ms = computed(() => (underWay.value.length > 0 ? undefined : parseTime(draft.value.icebergs_as_of)));

/** Describes the shown icebergs if they are not simply all recent ones; otherwise undefined. */
export const choiceInWords = computed<string | undefined>(() => {
  const choice = icebergChoice.value;
  if (!choice) return 'left out by the set-up';
  const { datasets, departure, max_sighting_age_days: days } = choice;
  const isOlder = departure !== undefined && oldestThatCounts_ms(Date.parse(departure), 0) < oldestThatCounts_ms(time_ms.value, 0);
  const words = [
    datasets && (datasets.length === 1 ? 'of the dataset chosen' : `of the ${datasets.length} datasets chosen`),
    days !== undefined && `seen within ${days} d`,
    isOlder && 'as the plan under way obeys them',
    knownAt_ms.value !== undefined && 'as known at the time set',
  ].filter((part) => typeof part === 'string');
  return words.length > 0 ? words.join(', ') : undefined;
});
