#pragma once

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Warns of escape routes that end so close to ice that the position error may put the vehicle below it. On an escape
/// route the vehicle navigates with the same estimate of the current as at the waypoint.
/// Precondition  the plan has its surfacings from this run, not from a store
void warn_of_escapes_to_the_edge(Plan& plan, const cost::Sea& sea, const PlanRequest& request);

}  // namespace floeplan::planning::publish
