#pragma once

#include <algorithm>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/graph/grid_graph.hpp"
#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::search {

/// Of sums of the times of edges: bounds leave it room.
inline constexpr double rounding_of_times_s = 1e-3;

/// A grid laid into a sea with what is open of it at any time: made once, searched for any departure.
struct OpenGrid {
  cost::RouteGrid grid;
  graph::GridGraph graph;
  std::int64_t vertices{};  // in deep enough water and clear of icebergs
  std::int64_t edges{};     // directed, between them
  /// From the goal to where the vehicle may surface or has come to its last stop, at least; where that is bounded.
  core::Seconds least_after_goal{};
  /// Of the bound on the time without surfacing, how much has to be left at the goal for the way on from there; minded
  /// by searches for the earliest arrival.
  core::Seconds left_at_goal{};

  /// How much of that bound whoever comes to the goal must have left.
  [[nodiscard]] core::Seconds needed_after_goal() const { return std::max(least_after_goal, left_at_goal); }
};

/// How far an edge goes along either axis of the plane.
[[nodiscard]] core::Metres reach_of(const cost::RouteGrid& grid, const graph::GridGraph& graph);

/// Stops    early once `stop` is requested; the grid must then not be used
[[nodiscard]] OpenGrid open_grid(const cost::Sea& sea, const cost::RouteGrid& grid, int sectors,
                                 const std::stop_token& stop);

}  // namespace floeplan::planning::search
