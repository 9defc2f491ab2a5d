#include "engine/planning/publish/published_plan.hpp"

#include <utility>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/optimal_control/optimality.hpp"
#include "engine/planning/publish/battery_check.hpp"
#include "engine/planning/publish/escape_ends.hpp"
#include "engine/planning/publish/plan_assembly.hpp"
#include "engine/planning/search/escape.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/waiting/late_openings.hpp"
#include "engine/planning/search/waiting/time_killing.hpp"

namespace floeplan::planning::publish {

void add_warnings(Plan& plan, const PlanRequest& request) {
  if (plan.refinement && plan.refinement->end == RefinementEnd::time) {
    plan.warnings.push_back(
        "refinement ran out of its time; with more, or on another machine, the route may be a little better");
  }
  if (request.refine && request.method != Method::direct && !plan.refinement) {
    plan.warnings.push_back(
        "the way is that of the grid, without refinement: the better ones that it led to break what binds "
        "the way as a whole, such as the time without a place to surface");
  }
  if (plan.search.worst_fifo_violation)
    plan.warnings.push_back(search::describe(*plan.search.worst_fifo_violation));
  if (request.max_waypoints && plan.waypoints.size() > static_cast<std::size_t>(*request.max_waypoints)) {
    plan.warnings.push_back(
        "the route needs more waypoints than asked for; without them it would be closed or have longer legs "
        "than allowed");
  }
}

std::optional<Infeasible> add_escapes(Plan& plan, const search::Chart& chart, const PlanRequest& request,
                                      const std::vector<geo::PlanePoint>& points,
                                      const std::vector<core::Seconds>& arrivals,
                                      const std::vector<vehicle::Drive>& drives,
                                      const std::stop_token& stop) {
  if (!request.under_ice.escape_plan) return std::nullopt;
  auto escapes = search::plan_escapes(chart.sea, chart.layout, request, points, arrivals, drives,
                                      plan.surfacing->waypoints, stop);
  if (!escapes) return std::move(escapes.error());
  plan.surfacing->escapes = std::move(*escapes);
  warn_of_escapes_to_the_edge(plan, chart.sea, request);
  return check_escapes(plan, request);
}

Result<Plan> publish(const search::Chart& chart, const ocean::Environment& environment,
                     const PlanRequest& request, const Improved& improved, const SearchStatistics& statistics,
                     const std::stop_token& stop) {
  const cost::Sea& sea = chart.sea;
  const std::vector<geo::PlanePoint>& points = improved.route.points;
  const auto schedule = cost::schedule_along(sea, points, cost::at_departure);
  if (!schedule) return tl::unexpected(search::explain_route(schedule.error(), sea, request));
  const std::vector<vehicle::Drive> drives(improved.route.legs(), sea.drives().front());
  Plan plan = assemble_plan(sea, environment, request, points, *schedule, drives);
  plan.search = statistics;
  plan.refinement = improved.refinement;
  if (plan.refinement) plan.refinement->after = plan.travel_time();  // what came after it may have cost time
  if (auto exceeded = check_battery(plan, request)) return tl::unexpected(std::move(*exceeded));
  if (auto none = add_escapes(plan, chart, request, points, schedule->arrivals, drives, stop))
    return tl::unexpected(std::move(*none));
  if (request.max_loiter.count() == 0.0) {
    if (const auto killed = search::longest_killing_of_time(sea, improved.route, *schedule))
      plan.warnings.push_back(search::describe(*killed));
  }
  add_warnings(plan, request);
  return plan;
}

void rate(Plan& plan, const cost::Sea& sea, const PlanRequest& request, const cost::Route& route,
          const std::stop_token& stop) {
  if (!request.optimality_gap) return;
  const optimal_control::Optimality optimality = optimal_control::rate_route(sea, route, stop);
  plan.optimality_gap = optimality.gap;
  plan.optimality_gap_reason = optimality.reason;
}

}  // namespace floeplan::planning::publish
