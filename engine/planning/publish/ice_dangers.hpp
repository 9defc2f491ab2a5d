#pragma once

#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Adds messages about ice above the route. Dangers: a start, a goal or a via point under ice, and more than 12 h below ice
/// without a place to surface. Caution: a start or a goal whose ice is not known. There is no message about the time where
/// the pilot bounds the time without surfacing.
/// Rule     a place is under ice where the vehicle may not surface and its dives turn below keels, as in the simulator
/// Precondition  the plan tells of its surfacings, one state for each waypoint
void tell_of_ice_above(Plan& plan, const PlanRequest& request);

}  // namespace floeplan::planning::publish
