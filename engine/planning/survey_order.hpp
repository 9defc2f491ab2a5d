#pragma once

#include <optional>
#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"

namespace floeplan::planning {

/// The order of the vias that reaches the goal earliest; empty when no order leads there or `stop` is requested.
[[nodiscard]] std::optional<ViaOrder> best_via_order(const ocean::Environment& environment,
                                                     const PlanRequest& request, const std::stop_token& stop);

}  // namespace floeplan::planning
