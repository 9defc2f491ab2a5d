#pragma once

#include <stop_token>

#include "engine/core/clock.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::planner {

/// Plans the request for its departure as `plan_route` does, once: an infeasible request is not told what would help,
/// and one sort of grids is tried whatever the currents.
/// Errors and Stops  as `plan_route`
[[nodiscard]] Result<Plan> try_to_plan(const ocean::Environment& environment, const PlanRequest& request,
                                       const std::stop_token& stop, const core::ProgressCallback& progress,
                                       const core::SteadyClock& clock = {});

}  // namespace floeplan::planning::planner
