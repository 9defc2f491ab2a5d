#include "engine/planning/cost_voyage.hpp"

#include <algorithm>
#include <limits>

namespace floeplan::planning {

CostVoyage::CostVoyage(const Sea& sea, const RouteGrid& grid, const Objective& objective,
                       const Openings* openings)
    : sea_{sea},
      grid_{grid},
      objective_{objective},
      openings_{openings},
      goal_{grid.point(grid.goal)},
      steady_{sea.is_steady()},
      closures_{sea.has_timed_closures()} {}

double CostVoyage::key(graph::Vertex v, double, const State& state) const {
  double rest = std::numeric_limits<double>::infinity();
  for (const vehicle::Drive drive : sea_.drives()) {
    const core::Seconds time = sea_.least_time(grid_.point(v), goal_, drive);
    rest = std::min(rest, objective_.cost(time, sea_.energy().least_power(drive) * time));
  }
  return state.cost + rest;
}

}  // namespace floeplan::planning
