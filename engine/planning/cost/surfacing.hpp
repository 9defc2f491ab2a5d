#pragma once

#include <vector>

#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/surfacing_plan.hpp"

namespace floeplan::planning::cost {

/// Follows a route that is open for ice: where the vehicle may surface, when it does, and how its position error
/// grows between fixes.
/// Fixes    at the planned surfacings where an interval is asked for, else wherever the vehicle may surface
/// Surfacings  at the latest possible place before the interval is over with no ice within the error of the position;
///          where there is none, at the one with the most room, as long as that grows also a little later. The time
///          spent at the surface is not counted
/// Turns    those of a leg are looked at as its closures are, every `surfacing_look()` of the sea
/// Error    share of the distance through water + uncertainty of the currents times the time, since the last fix
/// Precondition: `schedule` is that of the route, with one of `drives` for each leg
[[nodiscard]] SurfacingPlan plan_surfacings(const Sea& sea, const PlanRequest& request,
                                            const std::vector<geo::PlanePoint>& route,
                                            const Schedule& schedule,
                                            const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning::cost
