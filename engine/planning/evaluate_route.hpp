#pragma once

#include <stop_token>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/route_ground.hpp"

namespace floeplan::planning {

/// Times a given route (at least two places): the same legs, the same edge integration, the same rules. Where legs may
/// have different drives, on those that make the whole cost least by the request's objective.
/// `request` gives departure, vehicle, margin and tolerance; its places and method are not used.
/// Errors   as plan_route
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> evaluate_route(const ocean::Environment& environment,
                                          const std::vector<geo::LonLat>& route, const PlanRequest& request,
                                          const std::stop_token& stop = {});

/// The same on the ground of the route's site, which gives the same figures whichever route it was laid out for; of the
/// request only the places may differ from the one that it was laid out for.
/// Errors   also std::invalid_argument for a ground of another site
[[nodiscard]] Result<Plan> evaluate_route(const search::RouteGround& ground,
                                          const std::vector<geo::LonLat>& route, const PlanRequest& request,
                                          const std::stop_token& stop = {});

}  // namespace floeplan::planning
