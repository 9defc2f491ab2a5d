#pragma once

#include <cmath>
#include <functional>
#include <stop_token>

#include "engine/core/progress.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/grid/search_outcome.hpp"

namespace floeplan::planning::search {

/// Searches the grid for the earliest arrival at its goal with the request's method (not Method::direct), of a vehicle
/// that holds where that brings it there earlier. For one that never holds it is the earliest arrival at each place that
/// counts, as in the paper: where something opens later there may be an earlier way, and the statistics say so.
/// Where the time without surfacing is bounded and the best way does not keep that bound, by search_with_surfacings
/// whatever the method.
/// `latest`: when the goal can certainly be reached by then, later ways need not be looked at, nor legs that open
/// later.
/// `since_surfacing`: at the start, when that time is bounded.
/// `foresight`: of this grid, kept from search to search; without it one is made. Changes no result.
[[nodiscard]] RouteSearch search_route(const cost::Sea& sea, const OpenGrid& open, const PlanRequest& request,
                                       core::Seconds depart, const std::stop_token& stop,
                                       const std::function<void(double)>& report_fraction,
                                       core::Seconds latest = core::Seconds{INFINITY},
                                       core::Seconds since_surfacing = core::Seconds{0.0},
                                       Foresight* foresight = nullptr);

}  // namespace floeplan::planning::search
