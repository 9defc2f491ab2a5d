#pragma once

#include <cmath>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::planning::search {

/// The result of a search over one grid.
struct RouteSearch {
  std::vector<geo::PlanePoint> path;  // start and goal included; empty when the goal was not reached
  core::Seconds arrival{INFINITY};    // at the end of the path; infinite: no path
  SearchStatistics statistics;
  bool cancelled{false};
  geo::PlanePoint nearest;  // the reached point nearest to the goal
  core::Seconds nearest_arrival{};
  core::Seconds since_surfacing{};  // at the goal, if the time without surfacing is limited
  bool out_of_time{false};          // the data end before the end of an edge out of `nearest`
  std::vector<motion::EdgeClosed> closed_at_nearest;  // one reason for each closed edge out of `nearest`
};

}  // namespace floeplan::planning::search
