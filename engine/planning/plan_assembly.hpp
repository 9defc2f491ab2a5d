#pragma once

#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"
#include "engine/planning/route_cost.hpp"
#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// Makes a plan of a route and its arrivals: waypoints with legs, clearances, warnings, the data used.
/// Precondition  as many arrivals as points, at least two, and a drive for each leg
[[nodiscard]] Plan assemble_plan(const Sea& sea, const ocean::Environment& environment,
                                 const PlanRequest& request, const std::vector<geo::PlanePoint>& route,
                                 const Schedule& schedule, const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning
