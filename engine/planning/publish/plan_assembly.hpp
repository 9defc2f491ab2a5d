#pragma once

#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Makes a plan from a route and its schedule: waypoints with legs, clearances, messages, the data used.
/// Precondition  as many arrivals as points, at least two, and a propulsion for each leg
/// Stops    early, with a plan that must not be used, once `stop` is requested
[[nodiscard]] Plan assemble_plan(const cost::Sea& sea, const ocean::Environment& environment,
                                 const PlanRequest& request, const std::vector<geo::PlanePoint>& route,
                                 const cost::Schedule& schedule, const std::vector<vehicle::Drive>& drives,
                                 const std::stop_token& stop);

}  // namespace floeplan::planning::publish
