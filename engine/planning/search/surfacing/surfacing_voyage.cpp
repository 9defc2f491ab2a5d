#include "engine/planning/search/surfacing/surfacing_voyage.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::search {

namespace {

core::Seconds step_time(const cost::RouteGrid& grid, core::MetresPerSecond speed) {
  return grid.shortest_step() / speed;
}

}  // namespace

bool SurfacingFronts::holds_better(graph::Vertex v, double arrival_s, std::int64_t span) const {
  return std::ranges::any_of(
      fronts_[v], [&](const Arrival& other) { return other.s <= arrival_s && other.span >= span; });
}

void SurfacingFronts::add(graph::Vertex v, double arrival_s, std::int64_t span) {
  std::erase_if(fronts_[v], [&](const Arrival& other) { return arrival_s <= other.s && span >= other.span; });
  fronts_[v].push_back({arrival_s, span});
}

SurfacingVoyage::SurfacingVoyage(const cost::Sea& sea, const OpenGrid& open, const Known& known,
                                 core::Seconds resolution, core::Seconds before, Aim aim, double weight)
    : sea_{sea},
      grid_{open.grid},
      goal_{open.grid.point(open.grid.goal)},
      closures_{known.closures},
      openings_{known.openings},
      reach_{known.reach},
      ladder_{known.ladder},
      step_s_{step_time(open.grid, sea.through_water()).count()},
      longest_s_{sea.domain().overhead().longest_without_surfacing()->count()},
      left_at_goal_s_{open.left_at_goal.count()},
      resolution_s_{resolution.count()},
      before_s_{before.count()},
      aim_{aim},
      weight_{weight},
      may_wait_{sea.holding().longest.count() > 0.0 && sea.domain().closures().any_timed()},
      indifferent_s_{aim == Aim::any_way && !may_wait_ ? step_s_ : 0.0},
      fronts_{open.graph.size()} {}

double SurfacingVoyage::earliest_at_goal_s(graph::Vertex v, double arrival_s) const {
  const double straight_s = arrival_s + sea_.least_time(grid_.point(v), goal_).count();
  if (ladder_ == nullptr || v == grid_.goal) return straight_s;
  return std::max(straight_s, ladder_->earliest_s(v, arrival_s));
}

std::int64_t SurfacingVoyage::span_of(double surfaced_s, double arrival_s) const {
  const double moment_s = aim_ == Aim::any_way ? surfaced_s - arrival_s : surfaced_s;
  return static_cast<std::int64_t>(std::floor(moment_s / resolution_s_));
}

double SurfacingVoyage::least_arrival_s(const graph::Edge& edge, double depart_s) const {
  if (ladder_ != nullptr) return depart_s + ladder_->least_time_s(edge, depart_s);
  return depart_s + sea_.least_time(grid_.point(edge.tail), grid_.point(edge.head)).count();
}

bool SurfacingVoyage::is_of_use(graph::Vertex v, double arrival_s) const {
  if (ladder_ != nullptr && arrival_s > ladder_->latest_use_s(v)) return false;
  return earliest_at_goal_s(v, arrival_s) < before_s_;
}

bool SurfacingVoyage::may_surface_along(geo::PlanePoint tail, geo::PlanePoint head) const {
  return sea_.least_time_to_opening(tail) <= sea_.least_time(tail, head);
}

bool SurfacingVoyage::can_surface_in_time(graph::Vertex v, double since_surfacing_s) const {
  if (v == grid_.goal && since_surfacing_s + left_at_goal_s_ > longest_s_) return false;
  return since_surfacing_s + reach_.least_until_opening_s(v) <= longest_s_;
}

bool SurfacingVoyage::may_wait_for(graph::Vertex v, const Label& first, const Label& other) const {
  if (first.state.interval != other.state.interval) return false;
  const core::Seconds from{first.arrival_s};
  const core::Seconds until{other.arrival_s};
  const geo::PlanePoint place = grid_.point(v);
  if (until - from > sea_.holding().longest || !cost::current_lets_stay(sea_, place, from, until))
    return false;
  const auto since = cost::since_surfacing_after_wait(sea_.domain().overhead(), place, from, until,
                                                      from - core::Seconds{first.state.surfaced_s});
  return since && *since <= until - core::Seconds{other.state.surfaced_s};
}

}  // namespace floeplan::planning::search
