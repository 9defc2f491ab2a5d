#include "engine/planning/planner/route_evaluation.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/planning/planner/cost_plan.hpp"
#include "engine/planning/publish/improvement.hpp"
#include "engine/planning/publish/published_plan.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::planner {

Result<Plan> evaluate_on_ground(const search::RouteGround& ground, const std::vector<geo::LonLat>& route,
                                const PlanRequest& request, const std::stop_token& stop) {
  const PlanRequest on_route = search::request_along(route, request);
  if (search::site_of(on_route) != ground.site())
    throw std::invalid_argument{"the ground is not that of the route"};

  cost::Layout layout = cost::lay_out(on_route, search::reach_beside(on_route), ground.projection());
  const Result<search::Chart> chart =
      search::chart_on(ground.sea(), ground.environment(), std::move(layout), on_route);
  if (!chart) return tl::unexpected(chart.error());
  if (chart->sea.drives().size() > 1) {
    Result<Plan> plan = publish_straight_way(*chart, ground.environment(), on_route, stop);
    if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
    // Holds need the first propulsion. So if the plan failed and holds are allowed, it is timed again with
    // that alone.
    if (plan || request.holds.longest.count() == 0.0) return plan;
  }
  publish::Improved given =
      publish::improve(chart->sea, cost::fixed_route(chart->layout.points), on_route, stop);
  Result<Plan> plan = publish::publish(*chart, ground.environment(), on_route, given, {}, stop);
  // The comparison is with the best route from start to goal, so it need not pass the inner waypoints.
  std::fill(given.route.fixed.begin() + 1, given.route.fixed.end() - 1, false);
  if (plan) publish::rate(*plan, chart->sea, on_route, given.route, stop);
  if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
  return plan;
}

Result<Plan> evaluate_in(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                         const PlanRequest& request, const std::stop_token& stop, cost::SeaShelf* shelf) {
  const PlanRequest on_route = search::request_along(route, request);
  const auto ground = search::lay_out_ground(environment, on_route, search::site_of(on_route), stop, shelf);
  if (!ground) return tl::unexpected(ground.error());
  return evaluate_on_ground(**ground, route, request, stop);
}

}  // namespace floeplan::planning::planner
