#pragma once

#include <stop_token>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::planner {

/// The plan with the latest departure that arrives by the request's `departures.arrive_by`, on the request's
/// own grids. If there is none, does not look for changes that would help.
/// Precondition  the request is valid and asks for an arrival
/// Errors   as `plan_arrival`
[[nodiscard]] Result<Plan> try_to_plan_arrival(const ocean::Environment& environment,
                                               const PlanRequest& request, const std::stop_token& stop,
                                               const core::ProgressCallback& progress,
                                               const core::Executor& executor);

}  // namespace floeplan::planning::planner
