import type { Position } from '../../src/contract/data_types';
import type { Plan } from '../../src/contract/types';

/** A plan along a route, an hour a leg. */
export function makePlan(id: string, route: Position[]): Plan {
  const start_ms = Date.parse('2026-11-20T00:00:00Z');
  const eta = (hours: number): string => new Date(start_ms + hours * 3_600_000).toISOString().replace('.000', '');
  return {
    plan_id: id, name: '', status: 'ok', method: 'astar', vehicle: 'v', departure: eta(0), arrival: eta(route.length - 1),
    travel_time_s: 3600 * (route.length - 1), distance_m: 1, energy_j: null, optimality_gap: null, optimality_gap_reason: '',
    waypoints: route.map(([lon, lat], index) => ({
      index, lon, lat, eta: eta(index), leg_m: null, course_deg: null, speed_over_ground_m_s: null, depth_m: null,
    })),
    search: { vertices: 0, edges: 0, edge_evaluations: 0, expansions: 0, reinsertions: 0, fifo_violations: 0, worst_fifo_violation: null, seconds: 0 },
    clearances: { iceberg_m: null, land_m: null, bottom_m: null }, datasets: [], warnings: [],
  };
}
