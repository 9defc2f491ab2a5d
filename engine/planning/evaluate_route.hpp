#pragma once

#include <stop_token>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/infeasible.hpp"
#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"

namespace floeplan::planning {

/// Times a given route (at least two places): the same legs, the same edge integration, the same rules.
/// `request` gives departure, vehicle, margin and tolerance; its places and method are not used.
/// Errors   as plan_route
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> evaluate_route(const ocean::Environment& environment,
                                          const std::vector<geo::LonLat>& route, const PlanRequest& request,
                                          const std::stop_token& stop = {});

}  // namespace floeplan::planning
