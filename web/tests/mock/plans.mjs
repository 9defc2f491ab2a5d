// Invented plans: a bowed line from start to goal through the invented currents.
import * as world from './world.mjs';

const refs = world.datasets.map(({ id, kind, name, sha256 }) => ({ id, kind, name, sha256 }));
const warnings = ['Synthetic data, not for navigation.', 'Berg D-09 was last seen 40 h before it is passed.'];

export function makePlan(inputs, plan_id) {
  for (const [which, [lon, lat]] of [['start', inputs.from], ['goal', inputs.to]]) {
    if (!world.isLand(lon, lat)) continue;
    return {
      status: 'infeasible', reason: `${which}_on_land`, at: { lon, lat }, when: inputs.depart,
      explanation: `The ${which} lies on land, 1.2 km from the nearest water.`,
      suggestion: `Move the ${which} to ${(lat - 0.02).toFixed(2)}° N ${Math.abs(lon - 0.6).toFixed(2)}° W.`, warnings: [], datasets: refs,
    };
  }
  const [from, to] = [inputs.from, inputs.to];
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const legs = 8;
  const bow = inputs.method === 'direct' ? 0 : -0.12;
  const waypoints = [];
  let time = Date.parse(inputs.depart);
  let total = 0;
  for (let i = 0; i <= legs; ++i) {
    const share = i / legs;
    const side = bow * Math.sin(Math.PI * share);
    const [lon, lat] = [from[0] + dx * share - side * dy * 2, from[1] + dy * share + side * dx * 0.5];
    const before = waypoints.at(-1);
    let leg = { leg_m: null, course_deg: null, speed_over_ground_m_s: null };
    if (before) {
      const [east, north] = [(lon - before.lon) * 111_320 * Math.cos((lat * Math.PI) / 180), (lat - before.lat) * 111_320];
      const metres = Math.hypot(east, north);
      const current = world.currentAt(lon, lat, time) ?? [0, 0];
      const speed = Math.max(0.1, (inputs.speed_m_s ?? 0.35) + (current[0] * east + current[1] * north) / metres);
      leg = { leg_m: metres, course_deg: ((Math.atan2(east, north) * 180) / Math.PI + 360) % 360, speed_over_ground_m_s: speed };
      time += (1000 * metres) / speed;
      total += metres;
    }
    waypoints.push({ index: i, lon, lat, eta: world.isoOf(time), ...leg, depth_m: world.depthAt(lon, lat) });
  }
  return {
    plan_id, name: inputs.name ?? '', status: 'ok', method: inputs.method ?? 'astar', vehicle: inputs.vehicle ?? 'slocum-g3-200',
    departure: inputs.depart, arrival: world.isoOf(time), travel_time_s: (time - Date.parse(inputs.depart)) / 1000, distance_m: total,
    energy_j: null, optimality_gap: 0.012, optimality_gap_reason: '', waypoints, created: world.isoOf(Date.now()),
    search: { vertices: 20812, edges: 331240, edge_evaluations: 182311, expansions: 9120, reinsertions: 0, fifo_violations: 0, worst_fifo_violation: null, seconds: 1.3 },
    clearances: { iceberg_m: 812, land_m: 5230, bottom_m: 41 }, datasets: refs, warnings,
  };
}
