#pragma once

#include <stop_token>

#include "engine/core/clock.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::planner {

/// Plans the route that arrives earliest in one sea, past the vias in the order given: on the nearer grids, and on
/// the wider ones where they may do better. Only the plan that is given back is compared with the best possible way.
/// Precondition  the request is valid
/// Errors and Stops  as plan_route
[[nodiscard]] Result<Plan> plan_fastest(const ocean::Environment& environment, const PlanRequest& request,
                                        const std::stop_token& stop, const core::ProgressCallback& progress,
                                        const core::SteadyClock& clock);

}  // namespace floeplan::planning::planner
