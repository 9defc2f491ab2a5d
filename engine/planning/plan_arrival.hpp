#pragma once

#include <stop_token>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/wider_sea.hpp"

namespace floeplan::planning {

/// The plan with the latest departure that arrives by the request's `departures.arrive_by`: the plan for this
/// departure alone or, if that is sooner at the goal, the route of a plan for an earlier departure. It arrives
/// at most a minute, or a thousandth of the travel time, before the wanted time,
/// unless closures prevent it.
/// Errors   Reason::arrival_too_early when even the earliest departure, `request.depart`, arrives later;
///          otherwise as plan_route
/// Throws   std::invalid_argument when `request.violations()` is not empty or no arrival is asked for
/// `wider`: as in plan_route. A larger area is tried if currents as fast as the vehicle leave no departure
/// with a plan in time.
[[nodiscard]] Result<Plan> plan_arrival(const ocean::Environment& environment, const PlanRequest& request,
                                        const std::stop_token& stop, const core::ProgressCallback& progress,
                                        const WiderSea& wider = {},
                                        const core::Executor& executor = core::in_order());

}  // namespace floeplan::planning
