#include "engine/planning/publish/published_plan.hpp"

#include <optional>
#include <utility>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/cost/held_schedule.hpp"
#include "engine/planning/cost/met_currents.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/ice/nearest_ice.hpp"
#include "engine/planning/optimal_control/optimality.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/position_error.hpp"
#include "engine/planning/publish/battery_check.hpp"
#include "engine/planning/publish/plan_assembly.hpp"
#include "engine/planning/search/escape.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::publish {
namespace {

/// An escape route as the vehicle flies it from its waypoint.
struct Flight {
  CarriedWay carried;  // displacement by currents beyond the vehicle's estimate
  core::Metres grown;  // growth of the position error by the rules
  core::Seconds ends;  // when the vehicle surfaces
};

Flight flown(const EscapeWay& escape, const cost::Sea& sea, const UnderIceRules& rules,
             core::Seconds arrives) {
  const core::Metres step = sea.domain().overhead().look();
  Flight flight{.carried = {}, .grown = {}, .ends = arrives};
  geo::PlanePoint from = sea.domain().projection().to_plane(escape.way.front());
  for (std::size_t i = 1; i < escape.way.size(); ++i) {
    const geo::PlanePoint to = sea.domain().projection().to_plane(escape.way[i]);
    const vehicle::Drive drive = escape.drives[i - 1];
    cost::Sea::Passage last{from, flight.ends};
    for (const cost::Sea::Passage& passage : sea.passages(from, to, flight.ends, step, drive)) {
      flight.carried = flight.carried + cost::carried_between(sea, last, passage);
      last = passage;
    }
    flight.grown = flight.grown + grown_error(rules, sea.speed(drive), last.time - flight.ends);
    flight.ends = last.time;
    from = to;
  }
  return flight;
}

/// Warns of escape routes that end so close to ice that the vehicle may surface below it because of its
/// position error. On an escape route the vehicle navigates with the same estimate of the current as at the
/// waypoint.
/// Precondition  the plan was made in this run: stored plans lack the data about its surfacings
void warn_of_escapes_to_the_edge(Plan& plan, const cost::Sea& sea, const PlanRequest& request) {
  if (!sea.domain().ice()) return;
  struct Near {
    std::size_t waypoint;
    core::Metres ice;
    core::Metres error;
  };
  std::size_t near = 0;
  std::optional<Near> first;
  for (std::size_t i = 0; i < plan.surfacing->escapes.size(); ++i) {
    const EscapeWay& escape = plan.surfacing->escapes[i];
    if (escape.way.size() < 2) continue;
    const core::Seconds arrives = plan.waypoints[i].eta - request.depart;
    const Flight flight = flown(escape, sea, request.under_ice, arrives);
    const auto& [off, with_current] = plan.surfacing->reckoned[i];
    const core::Metres by_rules = plan.surfacing->waypoints[i].position_error - off.length() + flight.grown;
    const CarriedWay off_at_end = off + flight.carried - with_current * (flight.ends - arrives);
    const core::Metres error = by_rules + off_at_end.length();
    const auto ice = ice::nearest_ice_within(
        error, *sea.domain().ice(), sea.domain().projection().to_plane(escape.way.back()), flight.ends);
    if (!ice || near++ > 0) continue;
    first = {i, *ice, error};
  }
  if (!first) return;
  plan.messages.push_back(messages::plan_message<"escapes-end-near-ice">(
                              near, first->waypoint, first->ice.value / 1000.0, first->error.value / 1000.0)
                              .at(plan.waypoints[first->waypoint].place));
}

}  // namespace

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
  if (!sea.domain().overhead().bounds_surfacing())
    *schedule = cost::departing_later(sea, points, *std::move(schedule));
  const std::vector<vehicle::Drive> drives(improved.route.legs(), sea.drives().front());
  Plan plan = assemble_plan(sea, environment, request, points, *schedule, drives, stop);
  plan.search = statistics;
  plan.refinement = improved.refinement;
  if (plan.refinement) plan.refinement->after = plan.travel_time();  // later steps may have added time
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
