#pragma once

#include <stop_token>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/route_ground.hpp"

namespace floeplan::planning::planner {

/// Times a given route on a leg cost model made for this route, or for another one of the same site; see
/// `evaluate_route`.
[[nodiscard]] Result<Plan> evaluate_on_ground(const search::RouteGround& ground,
                                              const std::vector<geo::LonLat>& route,
                                              const PlanRequest& request, const std::stop_token& stop);

/// Times a given route on a leg cost model that is made for it. `shelf`: see `Sea`.
[[nodiscard]] Result<Plan> evaluate_in(const ocean::Environment& environment,
                                       const std::vector<geo::LonLat>& route, const PlanRequest& request,
                                       const std::stop_token& stop, cost::SeaShelf* shelf = nullptr);

}  // namespace floeplan::planning::planner
