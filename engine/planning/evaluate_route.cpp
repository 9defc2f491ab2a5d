#include "engine/planning/evaluate_route.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/planning/chart.hpp"
#include "engine/planning/cost_plan.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/improvement.hpp"
#include "engine/planning/published_plan.hpp"

namespace floeplan::planning {

Result<Plan> evaluate_route(const RouteGround& ground, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request, const std::stop_token& stop) {
  const PlanRequest on_route = request_along(route, request);
  if (site_of(on_route) != ground.site()) throw std::invalid_argument{"the ground is not that of the route"};

  Layout layout = lay_out(on_route, reach_beside(on_route), ground.projection());
  const Result<Chart> chart = chart_on(ground.sea(), std::move(layout), on_route);
  if (!chart) return tl::unexpected(chart.error());
  if (chart->sea.drives().size() > 1) {
    Result<Plan> plan = publish_straight_way(*chart, ground.environment(), on_route, stop);
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    // On the first drive alone the vehicle may wait for what opens later.
    if (plan || request.max_loiter.count() == 0.0) return plan;
  }
  Improved given = improve(chart->sea, fixed_route(chart->layout.points), on_route, stop, {});
  Result<Plan> plan = publish(*chart, ground.environment(), on_route, given, {}, stop);
  // Compared with the best way from end to end, not with the best one past every place of the route.
  std::fill(given.route.fixed.begin() + 1, given.route.fixed.end() - 1, false);
  if (plan) rate(*plan, chart->sea, on_route, given.route, stop);
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
  return plan;
}

Result<Plan> evaluate_route(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request, const std::stop_token& stop) {
  const PlanRequest on_route = request_along(route, request);
  const auto ground = lay_out_ground(environment, on_route, site_of(on_route), stop);
  if (!ground) return tl::unexpected(ground.error());
  return evaluate_route(**ground, route, request, stop);
}

}  // namespace floeplan::planning
