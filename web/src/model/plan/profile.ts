import type { Position } from '../../contract/data_types';
import type { Plan, Probe } from '../../contract/types';
import { destination, inverse } from '../../geo/geodesic';

/** The data along a plan, at times spread over it. */
export interface ProfilePoint {
  time_ms: number;
  place: Position;
  course_deg: number;
  speed_over_ground_m_s: number | null;
  turn_m: number | null; // the least depth at which its dives turn
  probe: Probe | undefined; // undefined where the server could not be asked
}

/** Where the vehicle is at `count` moments from departure to arrival, and at each waypoint. */
export function momentsOf(plan: Plan, count: number): ProfilePoint[] {
  const points: ProfilePoint[] = [];
  const total_ms = Date.parse(plan.arrival) - Date.parse(plan.departure);
  plan.waypoints.slice(1).forEach((to, i) => {
    const from = plan.waypoints[i];
    if (!from) return;
    const [start_ms, end_ms] = [Date.parse(from.eta), Date.parse(to.eta)];
    const leg = inverse([from.lon, from.lat], [to.lon, to.lat]);
    const pieces = Math.max(1, Math.round((count * (end_ms - start_ms)) / Math.max(1, total_ms)));
    for (let k = points.length === 0 ? 0 : 1; k <= pieces; ++k) {
      const share = k / pieces;
      points.push({
        time_ms: start_ms + share * (end_ms - start_ms),
        place: destination([from.lon, from.lat], leg.azimuth_deg, share * leg.distance_m),
        course_deg: leg.azimuth_deg,
        speed_over_ground_m_s: to.speed_over_ground_m_s,
        turn_m: to.leg_upper_turn_m ?? to.least_upper_turn_m ?? null,
        probe: undefined,
      });
    }
  });
  return points;
}

/** The part of the current along the course: positive when it pushes. */
export function currentAlong_m_s({ probe, course_deg }: ProfilePoint): number | null {
  const { u_m_s = null, v_m_s = null } = probe?.currents ?? {};
  if (u_m_s === null || v_m_s === null) return null;
  const course = (course_deg * Math.PI) / 180;
  return u_m_s * Math.sin(course) + v_m_s * Math.cos(course);
}

/** Draft of level ice as a share of its thickness. */
const submerged = 0.9;

/** Draft of the deepest keel over the thickness of level ice, as plans take it (planning::keel_over_thickness: Lemieux et al. 2016). */
const keelOverThickness = 8;

const fromThickness = ({ probe }: ProfilePoint, factor: number): number | null => {
  const thickness_m = probe?.ice.thickness_m ?? null;
  return thickness_m === null ? null : factor * thickness_m;
};

export const iceDraft_m = (point: ProfilePoint): number | null => fromThickness(point, submerged);
export const iceKeel_m = (point: ProfilePoint): number | null => fromThickness(point, keelOverThickness);

export const nearestBerg_m = ({ probe }: ProfilePoint): number | null => probe?.icebergs_within[0]?.distance_m ?? null;
