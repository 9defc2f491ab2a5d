#include "engine/planning/evaluate_route.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/chart.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/improvement.hpp"
#include "engine/planning/published_plan.hpp"

namespace floeplan::planning {
namespace {

/// A route that is given needs no room for a search, only for the fastest way in open water that it is compared with,
/// which bends with the currents: it is a fraction of the work to chart that much. Ways of escape are searched for.
GridReach reach_beside(const PlanRequest& request) {
  constexpr GridReach beside_route{0.2, 0.1};
  return request.under_ice.escape_plan ? first_reach : beside_route;
}

}  // namespace

Result<Plan> evaluate_route(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request, const std::stop_token& stop) {
  if (route.size() < 2) throw std::invalid_argument{"a route has at least two places"};
  PlanRequest on_route = request;
  on_route.from = route.front();
  on_route.to = route.back();
  on_route.via.assign(route.begin() + 1, route.end() - 1);
  on_route.method = Method::direct;
  on_route.max_waypoints.reset();
  if (!on_route.spacing_along) {
    // The safety map gets the step that a plan from end to end would have, not one for each short leg.
    core::Metres length{0.0};
    for (std::size_t i = 1; i < route.size(); ++i)
      length = length + geo::geodesic_between(route[i - 1], route[i]).length;
    on_route.spacing_along = spacing_for(request, length).along;
  }
  throw_if_invalid(on_route);

  const Result<Chart> chart = draw_chart(environment, on_route, reach_beside(request), stop);
  if (!chart) return tl::unexpected(chart.error());
  Improved given = improve(chart->sea, fixed_route(chart->layout.points), on_route, stop, {});
  Result<Plan> plan = publish(*chart, environment, on_route, given, {}, stop);
  // Compared with the best way from end to end, not with the best one past every place of the route.
  std::fill(given.route.fixed.begin() + 1, given.route.fixed.end() - 1, false);
  if (plan) rate(*plan, chart->sea, on_route, given.route, stop);
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
  return plan;
}

}  // namespace floeplan::planning
