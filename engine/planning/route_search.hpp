#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/progress.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/planning/foresight.hpp"
#include "engine/planning/open_grid.hpp"
#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"
#include "engine/planning/sea.hpp"
#include "engine/planning/time_killing.hpp"

namespace floeplan::planning {

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

/// Searches the grid for the earliest arrival at its goal with the request's method (not Method::direct). Where
/// something that is closed for a while opens again before that arrival, also for ways that arrive somewhere later
/// than they could, but none that circles for too long (time_killing.hpp). Where the time without surfacing is bounded
/// and the best way does not keep that bound, by search_with_surfacings whatever the method.
/// `latest`: when the goal can certainly be reached by then, later ways need not be looked at, nor legs that open
/// later.
/// `since_surfacing`: at the start, when that time is bounded.
/// `foresight`: of this grid, kept from search to search; without it one is made. Changes no result.
[[nodiscard]] RouteSearch search_route(const Sea& sea, const OpenGrid& open, const PlanRequest& request,
                                       core::Seconds depart, const std::stop_token& stop,
                                       const std::function<void(double)>& report_fraction,
                                       core::Seconds latest = core::Seconds{INFINITY},
                                       core::Seconds since_surfacing = core::Seconds{0.0},
                                       Foresight* foresight = nullptr);

}  // namespace floeplan::planning
