#pragma once

#include <functional>
#include <stop_token>

#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/infeasible.hpp"
#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"

namespace floeplan::planning {

/// Plans the request in one environment.
using PlanIn = std::function<Result<Plan>(const ocean::Environment&)>;

/// Whether there are several currents to plan for: members of an ensemble or an error model.
[[nodiscard]] bool has_uncertain_currents(const ocean::Environment& environment, const PlanRequest& request);

/// A plan with its spread over all members. Without an objective over them it is the plan of the first currents. With one,
/// the routes planned for each member are candidates beside it: each is driven in every member as it would be in the first
/// currents, and the one whose costs by the request's objective are best over the members is published, timed in the
/// first currents. A candidate that fewer members let through comes after one that more let through.
/// Limits   icebergs drift in every member as the member's own currents carry them; candidates are the members'
///          own best routes, so that a compromise none of them would take is not found
/// Errors   as `plan_in`; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> plan_uncertain(const ocean::Environment& environment, const PlanRequest& request,
                                          const PlanIn& plan_in, const std::stop_token& stop,
                                          const core::ProgressCallback& progress);

}  // namespace floeplan::planning
