#include "engine/planning/search/energy/cost_voyage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::planning::search {
namespace {

/// To compare arrivals by their last surfacing, the limit on the time without surfacing is divided into this
/// number of parts. Between two surfacings a route loses at most one part.
constexpr double parts_of_bound = 6.0;

}  // namespace

CostVoyage::CostVoyage(const cost::Sea& sea, const OpenGrid& open, const Objective& objective,
                       const std::optional<Limit>& limit, const CostOutlook* outlook)
    : sea_{sea},
      grid_{open.grid},
      least_after_goal_{open.least_after_goal},
      objective_{objective},
      limit_{limit},
      outlook_{outlook},
      least_rate_{least_rate(sea, objective)},
      goal_{open.grid.point(open.grid.goal)},
      longest_without_surfacing_{sea.domain().overhead().bounds_surfacing()
                                     ? sea.domain().overhead().longest_without_surfacing()
                                     : std::nullopt},
      steady_{sea.domain().is_steady()} {}

double CostVoyage::least_rate(const cost::Sea& sea, const Objective& objective) {
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

tl::expected<cost::Sea::MeteredLeg, motion::EdgeClosed> CostVoyage::travel(geo::PlanePoint tail,
                                                                           geo::PlanePoint head,
                                                                           double arrival_s,
                                                                           double surfaced_s, double latest_s,
                                                                           vehicle::Drive drive) const {
  const core::Seconds now{arrival_s};
  if (longest_without_surfacing_) {
    return sea_.metered_leg(tail, head, now, core::Seconds{arrival_s - surfaced_s}, core::Seconds{INFINITY},
                            drive, cost::Dives::over_map);
  }
  return sea_.metered_leg(tail, head, now, core::Seconds{0.0}, core::Seconds{latest_s}, drive,
                          cost::Dives::over_map);
}

bool CostVoyage::can_surface_in_time(graph::Vertex v, core::Seconds since_surfacing) const {
  if (!longest_without_surfacing_) return true;
  const core::Seconds least =
      v == grid_.goal ? least_after_goal_ : sea_.least_time_to_opening(grid_.point(v));
  return since_surfacing + least <= *longest_without_surfacing_;
}

bool CostVoyage::surfaced_as_late(const graph::Label<State>& a, const graph::Label<State>& b) const {
  if (!longest_without_surfacing_ || a.state.surfaced_s == a.arrival_s) return true;
  const double part_s = longest_without_surfacing_->count() / parts_of_bound;
  return std::floor(a.state.surfaced_s / part_s) >= std::floor(b.state.surfaced_s / part_s);
}

double CostVoyage::key(graph::Vertex v, double arrival_s, const State& state) const {
  const double least = rest(v, arrival_s);
  return state.cost + (outlook_ != nullptr ? std::max(least, outlook_->rest(v, arrival_s)) : least);
}

}  // namespace floeplan::planning::search
