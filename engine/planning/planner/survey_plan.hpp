#pragma once

#include <functional>
#include <stop_token>

#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::planner {

/// Plans the request's vias in the order that reaches the goal earliest. Where there is no plan in that order, or one
/// that is later than the order promised, in a few other orders, too, and in the order given: travel times on coarse
/// grids do not tell all that closes and opens on the way.
/// Law      where there is a plan in the order given there is one, no later than that by more than a few percent where
///          the time is what is minded
/// `plan_in_order`  plans a request whose vias are in the order of their visits
/// Errors   why there is no plan in the order given
/// Stops    with Reason::cancelled
[[nodiscard]] Result<Plan> plan_survey(const ocean::Environment& environment, const PlanRequest& request,
                                       const std::function<Result<Plan>(const PlanRequest&)>& plan_in_order,
                                       const std::stop_token& stop, const core::ProgressCallback& progress);

}  // namespace floeplan::planning::planner
