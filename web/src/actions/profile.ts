import { datasets } from '../model/datasets';
import { countedAt_ms } from '../model/setup/iceberg_choice';
import { momentsOf, type ProfilePoint } from '../model/plan/profile';
import { isoOf } from '../model/time';
import * as api from './client';
import type { Plan } from '../contract/types';

const moments = 60;
const atOnce = 4;
const remembered = new Map<string, Promise<ProfilePoint[]>>();
const most = 20;

/** The data along a plan: the server is asked for about sixty times, a few at a time. */
export function profileOf(plan: Plan): Promise<ProfilePoint[]> {
  const known = remembered.get(plan.plan_id);
  if (known) return known;
  const profile = probeAll(plan, momentsOf(plan, moments));
  remembered.set(plan.plan_id, profile);
  profile.catch(() => remembered.delete(plan.plan_id));
  for (const oldest of remembered.keys()) {
    if (remembered.size <= most) break;
    remembered.delete(oldest);
  }
  return profile;
}

/**
 * Datasets to probe: the plan's icebergs, and for every other kind its dataset if it used only one. Datasets that are no longer stored are left out.
 * For joined runs the server chooses.
 */
function datasetsOf({ datasets: used }: Plan): string[] {
  const isAlone = (kind: string): boolean => used.filter((one) => one.kind === kind).length === 1;
  const isStored = (id: string): boolean => datasets.value?.some((one) => one.id === id) ?? false;
  return used.filter(({ id, kind }) => (kind === 'icebergs' || isAlone(kind)) && isStored(id)).map(({ id }) => id);
}

async function probeAll(plan: Plan, points: ProfilePoint[]): Promise<ProfilePoint[]> {
  const answers: ProfilePoint[] = [...points];
  const obeyed = { datasets: datasetsOf(plan), departure: isoOf(countedAt_ms(plan)), max_sighting_age_days: plan.sightings?.max_age_days };
  let next = 0;
  const work = async (): Promise<void> => {
    for (let i = next++; i < points.length; i = next++) {
      const point = points[i];
      if (!point) return;
      const probe = await api.probe(point.place, isoOf(point.time_ms), obeyed);
      answers[i] = { ...point, probe };
    }
  };
  await Promise.all(Array.from({ length: atOnce }, work));
  return answers;
}
