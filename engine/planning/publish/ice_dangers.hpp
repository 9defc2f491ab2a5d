#pragma once

#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Adds to the plan's messages what ice above it means: a start, a goal or via points under ice, and more than 12 h
/// below ice without a place to surface, are dangers; a start or a goal of which nothing is known is
/// a caution. A pilot who bounds the time without surfacing has said how long it may be.
/// Rule     under ice is where the vehicle may not surface and its dives turn below keels, as the simulator has it
/// Precondition  the plan tells of its surfacings, one state for each waypoint
void tell_of_ice_above(Plan& plan, const PlanRequest& request);

}  // namespace floeplan::planning::publish
