#include "engine/planning/evaluate_route.hpp"

#include "engine/planning/planner/route_evaluation.hpp"

namespace floeplan::planning {

Result<Plan> evaluate_route(const search::RouteGround& ground, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request, const std::stop_token& stop) {
  return planner::evaluate_on_ground(ground, route, request, stop);
}

Result<Plan> evaluate_route(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request, const std::stop_token& stop) {
  return planner::evaluate_in(environment, route, request, stop);
}

}  // namespace floeplan::planning
