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

/// Times a given route (at least two places) with the leg cost model that plans use. If the vehicle has
/// several kinds of propulsion, each leg gets the one that makes the total cost least by the request's
/// objective.
/// `request` gives departure, vehicle, margin and tolerance; its places and method are not used.
/// Errors   as plan_route
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> evaluate_route(const ocean::Environment& environment,
                                          const std::vector<geo::LonLat>& route, const PlanRequest& request,
                                          const std::stop_token& stop = {});

/// Times a route on a leg cost model made before (`RouteGround`) for this or another route of the same site.
/// The result is the same. The request may differ only in its places from the one that the model was made
/// for.
/// Errors   also std::invalid_argument for a model of another site
[[nodiscard]] Result<Plan> evaluate_route(const search::RouteGround& ground,
                                          const std::vector<geo::LonLat>& route, const PlanRequest& request,
                                          const std::stop_token& stop = {});

}  // namespace floeplan::planning
