#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::planning::search {

/// What stops a vehicle that goes on at once, and for how long it would have to turn in circles until that opens.
struct OpensLater {
  cost::RouteClosed closed;
  core::Seconds circling{};
  /// When the end of the way opens, where that is too late for any way there (`end_opens_too_late`).
  std::optional<core::Seconds> end_opens{};
};

/// What a search over one grid found.
struct RouteSearch {
  std::vector<geo::PlanePoint> path;  // start and goal included; empty when the goal was not reached
  core::Seconds arrival{INFINITY};    // at its end
  SearchStatistics statistics;
  bool cancelled{false};
  geo::PlanePoint nearest;  // the reached point nearest to the goal: where the search stopped
  core::Seconds nearest_arrival{};
  core::Seconds since_surfacing{};  // at the goal, where the time without surfacing is bounded
  bool out_of_time{false};          // some way onward has data now, but they end before it does
  std::vector<motion::EdgeClosed> closed_at_nearest;  // why its outgoing edges were closed, one entry each
  std::optional<OpensLater> opens_later;  // why no way was found, when one that circles until then would be
};

}  // namespace floeplan::planning::search
