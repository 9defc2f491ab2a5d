#include "engine/planning/cost_voyage.hpp"

#include <algorithm>
#include <limits>

namespace floeplan::planning {

CostVoyage::CostVoyage(const Sea& sea, const RouteGrid& grid, const Objective& objective,
                       const Openings* openings, const std::optional<Limit>& limit)
    : sea_{sea},
      grid_{grid},
      objective_{objective},
      openings_{openings},
      limit_{limit},
      least_rate_{least_rate(sea, objective)},
      goal_{grid.point(grid.goal)},
      steady_{sea.is_steady()},
      closures_{sea.has_timed_closures()} {}

double CostVoyage::least_rate(const Sea& sea, const Objective& objective) {
  constexpr core::Seconds second{1.0};
  double least = std::numeric_limits<double>::infinity();
  for (const vehicle::Drive drive : sea.drives()) {
    least = std::min(least, objective.cost(second, sea.energy().least_power(drive) * second));
  }
  return least;
}

double CostVoyage::rest(graph::Vertex v, double arrival_s) const {
  double straight = std::numeric_limits<double>::infinity();
  for (const vehicle::Drive drive : sea_.drives()) {
    const core::Seconds time = sea_.least_time(grid_.point(v), goal_, drive);
    straight = std::min(straight, objective_.cost(time, sea_.energy().least_power(drive) * time));
  }
  if (!limit_ || v == grid_.goal) return straight;
  return std::max(straight, least_rate_ * (limit_->ladder->earliest_s(v, arrival_s) - arrival_s));
}

double CostVoyage::key(graph::Vertex v, double arrival_s, const State& state) const {
  return state.cost + rest(v, arrival_s);
}

}  // namespace floeplan::planning
