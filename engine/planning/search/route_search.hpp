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

/// Searches the grid for the earliest arrival at its goal with the request's method (not Method::direct). The
/// vehicle holds where the request allows it and the arrival becomes earlier. If it may not hold, each place
/// keeps only its earliest arrival, as in the paper. Where something reopens, an earlier route may then
/// exist; the statistics say so. If the time without surfacing is limited and the best route exceeds the
/// limit, search_with_surfacings is used for every method.
/// `latest`: if the goal can certainly be reached by then, later routes and legs that open later are skipped.
/// `since_surfacing`: time since the last possible surfacing at the start, if that time is limited.
/// `foresight`: of this grid, kept between searches; null: one is made. It does not change the result.
[[nodiscard]] RouteSearch search_route(const cost::Sea& sea, const OpenGrid& open, const PlanRequest& request,
                                       core::Seconds depart, const std::stop_token& stop,
                                       const std::function<void(double)>& report_fraction,
                                       core::Seconds latest = core::Seconds{INFINITY},
                                       core::Seconds since_surfacing = core::Seconds{0.0},
                                       Foresight* foresight = nullptr);

}  // namespace floeplan::planning::search
