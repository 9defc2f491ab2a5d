#include "engine/planning/plan_route.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/battery_check.hpp"
#include "engine/planning/chart.hpp"
#include "engine/planning/cost_plan.hpp"
#include "engine/planning/escape.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/improvement.hpp"
#include "engine/planning/late_openings.hpp"
#include "engine/planning/optimality.hpp"
#include "engine/planning/plan_assembly.hpp"
#include "engine/planning/relaxation.hpp"
#include "engine/planning/robust_plan.hpp"
#include "engine/planning/route_cost.hpp"
#include "engine/planning/tour_legs.hpp"
#include "engine/planning/visiting_order.hpp"
#include "engine/planning/voyage_search.hpp"

namespace floeplan::planning {
namespace {

constexpr core::Seconds at_departure{0.0};

FoundWay straight_way(const Layout& layout) {
  FoundWay way;
  way.route.points = layout.points;
  way.route.fixed.assign(layout.points.size(), true);
  return way;
}

/// The plan of a route, timed once more by the one cost.
Result<Plan> publish(const Chart& chart, const ocean::Environment& environment, const PlanRequest& request,
                     const Improved& improved, const SearchStatistics& statistics,
                     const std::stop_token& stop) {
  const Sea& sea = chart.sea;
  const std::vector<geo::PlanePoint>& points = improved.route.points;
  const auto arrivals = arrivals_along(sea, points, at_departure);
  if (!arrivals) return tl::unexpected(explain_route(arrivals.error(), sea, request));
  const std::vector<vehicle::Drive> drives(improved.route.legs(), sea.drives().front());
  Plan plan = assemble_plan(sea, environment, request, points, *arrivals, drives);
  plan.search = statistics;
  if (auto exceeded = check_battery(plan, request)) return tl::unexpected(std::move(*exceeded));
  plan.refinement = improved.refinement;
  if (plan.refinement && plan.refinement->end == RefinementEnd::time) {
    plan.warnings.push_back(
        "refinement ran out of its time; with more, or on another machine, the route may be a little faster");
  }
  if (statistics.worst_fifo_violation) plan.warnings.push_back(describe(*statistics.worst_fifo_violation));
  if (request.under_ice.escape_plan) {
    auto escapes =
        plan_escapes(sea, chart.layout, request, points, *arrivals, plan.surfacing->waypoints, stop);
    if (!escapes) return tl::unexpected(std::move(escapes.error()));
    plan.surfacing->escapes = std::move(*escapes);
  }
  if (request.max_waypoints && plan.waypoints.size() > static_cast<std::size_t>(*request.max_waypoints)) {
    plan.warnings.push_back(
        "the route needs more waypoints than asked for; without them it would be closed or have longer legs "
        "than allowed");
  }
  return plan;
}

/// How near the best possible the plan's route is, where that was asked for.
void rate(Plan& plan, const Sea& sea, const PlanRequest& request, const Route& route,
          const std::stop_token& stop) {
  if (!request.optimality_gap) return;
  const Optimality optimality = rate_route(sea, route, stop);
  plan.optimality_gap = optimality.gap;
  plan.optimality_gap_reason = optimality.reason;
}

/// A plan on grids of one reach and whether a larger reach may do better.
struct Attempt {
  Result<Plan> plan;
  bool wider_may_help{false};
};

Attempt plan_within(GridReach reach, const ocean::Environment& environment, const PlanRequest& request,
                    const std::stop_token& stop, const core::ProgressCallback& progress,
                    const core::SteadyClock& clock) {
  progress("environment", 0.0);
  const Result<Chart> chart = draw_chart(environment, request, reach, stop);
  if (!chart) return {tl::unexpected(chart.error())};

  FoundWay way = straight_way(chart->layout);
  if (request.method != Method::direct) {
    const auto report = [&](double fraction) { progress("search", 0.1 + 0.8 * fraction); };
    const std::vector<OpenGrid> grids = open_grids(chart->sea, chart->layout.grids, request.sectors, stop);
    auto found = search_voyage(chart->sea, grids, request, at_departure, stop, report);
    if (!found) {
      const bool cancelled = found.error().reason == Reason::cancelled;
      return {tl::unexpected(std::move(found.error())), !cancelled};
    }
    way = std::move(*found);
  }

  progress("refinement", 0.9);
  const Improved improved = improve(chart->sea, way.route, request, stop, clock);
  if (stop.stop_requested()) return {tl::unexpected(explain_cancelled(request))};
  Result<Plan> plan = publish(*chart, environment, request, improved, way.statistics, stop);
  if (plan && way.cut_short) {
    plan->warnings.push_back(
        "the search for better ways past what clears later was cut short at its bound on memory");
  }
  if (plan) rate(*plan, chart->sea, request, improved.route, stop);
  if (stop.stop_requested()) return {tl::unexpected(explain_cancelled(request))};
  progress("done", 1.0);
  return {std::move(plan), way.touches_rim};
}

/// Plans on the nearer grids, and on the wider ones where they may do better.
Result<Plan> plan_anywhere(const ocean::Environment& environment, const PlanRequest& request,
                           const std::stop_token& stop, const core::ProgressCallback& progress,
                           const core::SteadyClock& clock) {
  const Attempt first = plan_within(first_reach, environment, request, stop, progress, clock);
  if (!first.wider_may_help) return first.plan;

  const Attempt second = plan_within(second_reach, environment, request, stop, progress, clock);
  if (first.plan && (!second.plan || first.plan->arrival <= second.plan->arrival)) return first.plan;
  return second.plan;
}

/// Inputs whose change makes a way possible. The trials are searches alone, on a grid of bounded size.
std::vector<Change> changes_that_help(const ocean::Environment& environment, const PlanRequest& request,
                                      Constraint binding, const std::stop_token& stop) {
  constexpr double most_vertices_of_a_trial = 1e5;  // a few tenths of a second each
  if (lay_out(request, first_reach).most_vertices() > most_vertices_of_a_trial) return {};
  const Trial trial = [&](const PlanRequest& changed) {
    PlanRequest plain = changed;
    plain.refine = false;
    plain.optimality_gap = false;
    plain.max_waypoints.reset();
    return plan_anywhere(environment, plain, stop, [](std::string_view, double) {}, {}).has_value();
  };
  return find_changes(environment, request, binding, trial, stop);
}

/// The order of the vias that reaches the goal earliest; empty when no order leads there.
std::optional<ViaOrder> best_via_order(const ocean::Environment& environment, const PlanRequest& request,
                                       const std::stop_token& stop) {
  const Result<Chart> chart = draw_chart(environment, request, second_reach, stop);
  if (!chart) return std::nullopt;
  TourLegs legs{chart->sea, chart->layout, request, stop};
  const TourLegTime leg_time = [&](std::size_t from, std::size_t to, core::Seconds depart) {
    return legs.time(from, to, depart);
  };
  const auto order = best_visiting_order(request.via.size(), at_departure, leg_time, stop);
  if (!order) return std::nullopt;
  ViaOrder result{{}, order->exact};
  for (const std::size_t place : order->places) result.vias.push_back(place - 1);
  return result;
}

/// Plans the visits in their best order; where no order is possible, in the order given, which then says why.
Result<Plan> plan_survey(const ocean::Environment& environment, const PlanRequest& request,
                         const std::stop_token& stop, const core::ProgressCallback& progress,
                         const core::SteadyClock& clock) {
  progress("order of visits", 0.0);
  const auto order = best_via_order(environment, request, stop);
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
  PlanRequest ordered = request;
  ordered.via_in_best_order = false;
  for (std::size_t i = 0; order && i < order->vias.size(); ++i) ordered.via[i] = request.via[order->vias[i]];
  Result<Plan> plan = plan_route(environment, ordered, stop, progress, clock);
  if (plan) plan->via_order = order;
  return plan;
}

void refuse_invalid(const PlanRequest& request) {
  const core::Violations violations = request.violations();
  if (!violations.empty())
    throw std::invalid_argument{violations.front().field + ' ' + violations.front().rule};
}

}  // namespace

Result<Plan> plan_route(const ocean::Environment& environment, const PlanRequest& request,
                        const std::stop_token& stop, const core::ProgressCallback& report,
                        const core::SteadyClock& clock) {
  refuse_invalid(request);
  const core::ProgressCallback progress = report ? report : [](std::string_view, double) {};
  if (request.via_in_best_order) return plan_survey(environment, request, stop, progress, clock);
  if (!request.energy.objective.is_time()) {
    Result<Plan> plan = plan_least_cost(environment, request, stop, progress, clock);
    if (plan && has_uncertain_currents(environment, request)) {
      plan->warnings.push_back("how uncertain the currents are counts only where the objective is time");
    }
    if (plan && request.optimality_gap) {
      plan->optimality_gap_reason = "only plans for the least time are compared with the best way";
    }
    return plan;
  }
  const bool is_uncertain = has_uncertain_currents(environment, request);
  PlanRequest in_one_sea = request;
  in_one_sea.optimality_gap = request.optimality_gap && !is_uncertain;
  const PlanIn plan_in = [&](const ocean::Environment& sea) {
    return plan_anywhere(sea, in_one_sea, stop, progress, clock);
  };
  Result<Plan> plan =
      is_uncertain ? plan_uncertain(environment, in_one_sea, plan_in, stop, progress) : plan_in(environment);
  if (plan && is_uncertain && request.optimality_gap) {
    plan->optimality_gap_reason = "the currents are not certain, so that no one way is the best";
  }
  if (plan || !plan.error().changes.empty()) return plan;
  progress("what would help", 0.95);
  plan.error().changes = changes_that_help(environment, request, plan.error().binding, stop);
  return plan;
}

Result<Plan> evaluate_route(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request) {
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
  refuse_invalid(on_route);

  const Result<Chart> chart = draw_chart(environment, on_route, first_reach, {});
  if (!chart) return tl::unexpected(chart.error());
  Improved given = improve(chart->sea, straight_way(chart->layout).route, on_route, {}, {});
  Result<Plan> plan = publish(*chart, environment, on_route, given, {}, {});
  // Compared with the best way from end to end, not with the best one past every place of the route.
  std::fill(given.route.fixed.begin() + 1, given.route.fixed.end() - 1, false);
  if (plan) rate(*plan, chart->sea, on_route, given.route, {});
  return plan;
}

}  // namespace floeplan::planning
