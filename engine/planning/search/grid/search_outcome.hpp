#pragma once

#include <cmath>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::planning::search {

/// What a search over one grid found.
struct RouteSearch {
  std::vector<geo::PlanePoint> path;  // start and goal included; empty when the goal was not reached
  core::Seconds arrival{INFINITY};    // at the end of the path
  SearchStatistics statistics;
  bool cancelled{false};
  geo::PlanePoint nearest;  // the reached point nearest to the goal: where the search stopped
  core::Seconds nearest_arrival{};
  core::Seconds since_surfacing{};  // at the goal, where the time without surfacing is bounded
  bool out_of_time{false};          // the data end before the vehicle would reach the end of some edge onward
  std::vector<motion::EdgeClosed> closed_at_nearest;  // why its outgoing edges were closed, one entry each
};

}  // namespace floeplan::planning::search
