import { countedAt_ms } from '../model/iceberg_choice';
import { momentsOf, type ProfilePoint } from '../model/profile';
import { isoOf } from '../model/time';
import * as api from './client';
import type { Plan } from '../contract/types';

const moments = 60;
const atOnce = 4;
const remembered = new Map<string, Promise<ProfilePoint[]>>();
const most = 20;

/** What lies along a plan: the server is asked at some sixty moments, a few at a time. */
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

async function probeAll(plan: Plan, points: ProfilePoint[]): Promise<ProfilePoint[]> {
  const answers: ProfilePoint[] = [...points];
  const age = { departure: isoOf(countedAt_ms(plan)), max_sighting_age_days: plan.sightings?.max_age_days }; // the icebergs that the plan obeys
  let next = 0;
  const work = async (): Promise<void> => {
    for (let i = next++; i < points.length; i = next++) {
      const point = points[i];
      if (!point) return;
      const [lon, lat] = point.place;
      const probe = await api.probe(Number(lon.toFixed(6)), Number(lat.toFixed(6)), isoOf(point.time_ms), age);
      answers[i] = { ...point, probe };
    }
  };
  await Promise.all(Array.from({ length: atOnce }, work));
  return answers;
}
