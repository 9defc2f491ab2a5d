#pragma once

#include <functional>
#include <stop_token>

#include "engine/core/clock.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::planner {

/// Plans with the request's weight on expected encounters with icebergs: the plan without the weight, unless another
/// one expects fewer of them and costs less with it. So the weight never makes a plan expect more encounters.
/// `plan_unweighted` makes the plan without the weight, of the request without it.
/// Errors   as plan_route
/// Stops    as plan_route
[[nodiscard]] Result<Plan> plan_with_fewer_encounters(
    const ocean::Environment& environment, const PlanRequest& request,
    const std::function<Result<Plan>(const PlanRequest&)>& plan_unweighted, const std::stop_token& stop,
    const core::ProgressCallback& progress, const core::SteadyClock& clock);

}  // namespace floeplan::planning::planner
