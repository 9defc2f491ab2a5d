#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "engine/planning/driven_route.hpp"
#include "engine/planning/infeasible.hpp"
#include "engine/planning/open_grid.hpp"
#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"
#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// The way of least cost by the request's objective, from stop to stop as the grids give it.
struct CostWay {
  DrivenRoute route;
  SearchStatistics statistics;
  bool touches_rim{false};  // it keeps to the rim of a grid, beyond which a better way may lie
};

/// Searches grid after grid for the least cost to the next stop, each from the arrival at the last: between two
/// stops the best, over several stops as good as it gets without looking ahead. Where a search is cut short, the
/// way is that of the earliest arrival.
/// Errors   where and why there is no way
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<CostWay> search_least_cost(const Sea& sea, const std::vector<OpenGrid>& grids,
                                                const PlanRequest& request, core::Seconds depart,
                                                const std::stop_token& stop,
                                                const std::function<void(double)>& report_fraction);

}  // namespace floeplan::planning
