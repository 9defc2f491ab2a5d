#pragma once

#include <vector>

#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/surfacing_plan.hpp"

namespace floeplan::planning::cost {

/// Follows an open route below ice: where the vehicle may surface, when it does, and how its position error
/// grows between fixes.
/// Fixes    at the planned surfacings if an interval is requested, otherwise wherever the vehicle may surface
/// Surfacings  at the last place before the interval is over that has no ice within the position error. If
///             there is none, at the place farthest from ice, even a little later if that distance grows. The
///             time at the surface is not counted
/// Turns    the depth at which the vehicle must turn below ice is looked up along a leg in steps of
///          `Overhead::look()`
/// Error    share of the distance through water + uncertainty of the currents times the time, both since the
///          last fix
/// Precondition  `schedule` belongs to the route, with one of `drives` for each leg
[[nodiscard]] SurfacingPlan plan_surfacings(const Sea& sea, const PlanRequest& request,
                                            const std::vector<geo::PlanePoint>& route,
                                            const Schedule& schedule,
                                            const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning::cost
