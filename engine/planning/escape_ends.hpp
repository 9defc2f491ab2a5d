#pragma once

#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"
#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// Warns of escapes that come up where the error of the position, grown on their way, may have the vehicle below the
/// ice. On an escape it reckons with the current that it reckons with at the waypoint.
/// Precondition  the plan has its surfacings, of this run and not of a store
void warn_of_escapes_to_the_edge(Plan& plan, const Sea& sea, const PlanRequest& request);

}  // namespace floeplan::planning
