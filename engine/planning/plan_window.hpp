#pragma once

#include <stop_token>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/wider_sea.hpp"
#include "engine/planning/problem/window_plan.hpp"

namespace floeplan::planning {

/// Compares the departures of the request's window and plans the best of them.
/// `wider`: as in plan_route. If currents as fast as the vehicle leave no departure with a plan, all
/// departures are compared in a larger area.
[[nodiscard]] WindowPlan plan_window(const ocean::Environment& environment, const PlanRequest& request,
                                     const std::stop_token& stop, const core::ProgressCallback& progress,
                                     const WiderSea& wider = {},
                                     const core::Executor& executor = core::in_order());

}  // namespace floeplan::planning
