#include "engine/planning/evaluate_route.hpp"

#include "engine/planning/planner/route_evaluation.hpp"

namespace floeplan::planning {

Result<Plan> evaluate_route(const search::RouteGround& ground, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request, const std::stop_token& stop) {
  return planner::evaluate_on_ground(ground, route, request, stop);
}

Result<Plan> evaluate_route(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request, const std::stop_token& stop) {
  const PlanRequest on_route = search::request_along(route, request);
  const auto ground = search::lay_out_ground(environment, on_route, search::site_of(on_route), stop);
  if (!ground) return tl::unexpected(ground.error());
  return evaluate_route(**ground, route, request, stop);
}

}  // namespace floeplan::planning
