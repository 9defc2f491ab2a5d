#pragma once

#include <algorithm>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/graph/grid_graph.hpp"
#include "engine/planning/cost/planning_domain.hpp"
#include "engine/planning/cost/route_grid.hpp"

namespace floeplan::planning::search {

/// Bound of the rounding error of sums of edge times, in seconds.
inline constexpr double rounding_of_times_s = 1e-3;

/// A grid in a planning domain, without the vertices that are never open. It is made once and then searched
/// for any departure.
struct OpenGrid {
  cost::RouteGrid grid;
  graph::GridGraph graph;
  std::int64_t vertices{};  // in deep enough water and clear of icebergs
  std::int64_t edges{};     // directed edges between these vertices
  /// Least time from the goal to a place where the vehicle may surface, or to its last stop, if the time without
  /// surfacing is bounded.
  core::Seconds least_after_goal{};
  /// The part of the limit on the time without surfacing that must be left at the goal for the rest of the route.
  /// Searches for the earliest arrival obey it.
  core::Seconds left_at_goal{};

  /// The part of the limit on the time without surfacing that must be left at the goal.
  [[nodiscard]] core::Seconds needed_after_goal() const { return std::max(least_after_goal, left_at_goal); }
};

/// The largest extent of an edge along either axis of the plane.
[[nodiscard]] core::Metres reach_of(const cost::RouteGrid& grid, const graph::GridGraph& graph);

/// Finds the vertices of `grid` that are open at some time. `sectors`: size of the neighbourhood (k-sector
/// grid).
/// Stops    early once `stop` is requested; the grid must then not be used
[[nodiscard]] OpenGrid open_grid(const cost::PlanningDomain& domain, const cost::RouteGrid& grid, int sectors,
                                 const std::stop_token& stop);

}  // namespace floeplan::planning::search
