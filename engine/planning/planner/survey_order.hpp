#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::planner {

/// An order of the vias, and how long its way takes as far as travel times on coarse grids tell.
struct EstimatedOrder {
  ViaOrder order;
  core::Seconds travel_time{};
};

/// The order of the vias that reaches the goal earliest; empty when no order leads there or `stop` is requested.
[[nodiscard]] std::optional<EstimatedOrder> best_via_order(const ocean::Environment& environment,
                                                           const PlanRequest& request,
                                                           const std::stop_token& stop);

/// The orders that are likely to reach the goal early, for who found no way along the best one, which is among them or
/// not; of more than five vias one at most.
/// `most`   orders, at least one
/// Returns  the earliest first; fewer once `stop` is requested
[[nodiscard]] std::vector<EstimatedOrder> promising_via_orders(const ocean::Environment& environment,
                                                               const PlanRequest& request, std::size_t most,
                                                               const std::stop_token& stop);

}  // namespace floeplan::planning::planner
