#pragma once

#include <stop_token>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/wider_sea.hpp"
#include "engine/planning/problem/window_plan.hpp"

namespace floeplan::planning {

/// Compares the departures of the request's window and plans for the best of them.
/// `wider`: as plan_route's. Where no departure has a plan for currents as fast as the vehicle, all are
/// compared with more room.
[[nodiscard]] WindowPlan plan_window(const ocean::Environment& environment, const PlanRequest& request,
                                     const std::stop_token& stop, const core::ProgressCallback& progress,
                                     const WiderSea& wider = {},
                                     const core::Executor& executor = core::in_order());

}  // namespace floeplan::planning
