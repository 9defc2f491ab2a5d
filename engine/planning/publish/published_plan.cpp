#include "engine/planning/publish/published_plan.hpp"

#include <utility>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/cost/held_schedule.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/optimal_control/optimality.hpp"
#include "engine/planning/publish/battery_check.hpp"
#include "engine/planning/publish/escape_ends.hpp"
#include "engine/planning/publish/plan_assembly.hpp"
#include "engine/planning/search/escape.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::publish {

void add_messages(Plan& plan, const PlanRequest& request) {
  if (request.refine && request.method != Method::direct && !plan.refinement) {
    plan.messages.push_back(messages::plan_message<"route-not-refined">());
  }
  constexpr core::Seconds worth_a_note{600.0};
  if (const core::Seconds later = plan.waypoints.front().wait; later >= worth_a_note) {
    plan.messages.push_back(
        messages::plan_message<"may-depart-later">(later.count() / 3600.0, plan.departure + later)
            .at(plan.waypoints.front().place));
  }
  if (plan.search.holds_may_help) plan.messages.push_back(messages::plan_message<"route-without-holds">());
  if (request.max_waypoints && plan.waypoints.size() > static_cast<std::size_t>(*request.max_waypoints)) {
    plan.messages.push_back(messages::plan_message<"more-waypoints-than-asked">());
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
  auto schedule = cost::schedule_along(sea, points, cost::at_departure);
  if (!schedule) return tl::unexpected(search::explain_route(schedule.error(), sea, request));
  if (!sea.overhead().bounds_surfacing())
    *schedule = cost::departing_later(sea, points, *std::move(schedule));
  const std::vector<vehicle::Drive> drives(improved.route.legs(), sea.drives().front());
  Plan plan = assemble_plan(sea, environment, request, points, *schedule, drives, stop);
  plan.search = statistics;
  plan.refinement = improved.refinement;
  if (plan.refinement) plan.refinement->after = plan.travel_time();  // later steps may have cost time
  if (auto exceeded = check_battery(plan, request)) return tl::unexpected(std::move(*exceeded));
  if (auto none = add_escapes(plan, chart, request, points, schedule->arrivals, drives, stop))
    return tl::unexpected(std::move(*none));
  add_messages(plan, request);
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
