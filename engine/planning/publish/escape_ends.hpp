#pragma once

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Warns of escapes that come up where the error of the position, grown on their way, may have the vehicle below the
/// ice. On an escape it reckons with the current that it reckons with at the waypoint.
/// Precondition  the plan has its surfacings, of this run and not of a store
void warn_of_escapes_to_the_edge(Plan& plan, const cost::Sea& sea, const PlanRequest& request);

}  // namespace floeplan::planning::publish
