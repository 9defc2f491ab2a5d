#include "engine/planning/cost_plan.hpp"

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/planning/battery_check.hpp"
#include "engine/planning/chart.hpp"
#include "engine/planning/cost_search.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/fastest_plan.hpp"
#include "engine/planning/plan_assembly.hpp"
#include "engine/planning/published_plan.hpp"

namespace floeplan::planning {
namespace {

constexpr core::Seconds at_departure{0.0};
constexpr const char* no_gap = "only plans for the least time are compared with the best way";

double cost_of(const Plan& plan, const Objective& objective) {
  return objective.cost(plan.travel_time(), plan.energy->use.total(), plan.iceberg_encounters.value_or(0.0));
}

DrivenRoute straight_way(const Layout& layout, vehicle::Drive drive) {
  const std::size_t points = layout.points.size();
  return {.points = layout.points,
          .fixed = std::vector<bool>(points, true),
          .drives = std::vector<vehicle::Drive>(points - 1, drive)};
}

/// The straight way on the drives that make the whole cost least, begun from each drive on all legs: on one of them alone
/// it may be closed.
DrivenRoute best_straight_way(const Sea& sea, const Layout& layout, const Objective& objective,
                              const std::stop_token& stop) {
  DrivenRoute best = straight_way(layout, sea.drives().front());
  double least = INFINITY;
  for (const vehicle::Drive drive : sea.drives()) {
    DrivenRoute route = choose_drives(sea, straight_way(layout, drive), objective, at_departure, stop);
    const auto times = drive_along(sea, route, at_departure);
    if (!times || !(times->cost(objective) < least)) continue;
    least = times->cost(objective);
    best = std::move(route);
  }
  return best;
}

/// What is done to the way of the grid before it is published.
DrivenRoute improve(const Sea& sea, const DrivenRoute& route, const PlanRequest& request,
                    const std::stop_token& stop) {
  const Objective objective = request.objective();
  DrivenRoute improved = route;
  if (request.refine && request.method != Method::direct) {
    improved = drop_costless_points(sea, improved, objective, at_departure, stop);
  }
  if (request.max_waypoints) {
    const auto most = static_cast<std::size_t>(*request.max_waypoints);
    improved = drop_to(sea, improved, objective, at_departure, most, stop);
  }
  improved = choose_drives(sea, improved, objective, at_departure, stop);
  if (request.max_leg) improved = part_long_legs(sea, improved, *request.max_leg);
  return improved;
}

Result<Plan> publish(const Chart& chart, const ocean::Environment& environment, const PlanRequest& request,
                     const DrivenRoute& route, const SearchStatistics& statistics,
                     const std::stop_token& stop) {
  const Sea& sea = chart.sea;
  const auto times = drive_along(sea, route, at_departure);
  if (!times) {
    const RouteClosed closed{.reason = times.error(), .at = route.points.front()};
    return tl::unexpected(explain_route(closed, sea, request));
  }
  const Schedule schedule{times->arrivals, std::vector<core::Seconds>(times->arrivals.size())};
  Plan plan = assemble_plan(sea, environment, request, route.points, schedule, route.drives);
  plan.search = statistics;
  if (request.optimality_gap) plan.optimality_gap_reason = no_gap;
  if (auto exceeded = check_battery(plan, request)) return tl::unexpected(std::move(*exceeded));
  if (auto none = add_escapes(plan, chart, request, route.points, times->arrivals, route.drives, stop))
    return tl::unexpected(std::move(*none));
  if (statistics.cut_short) {
    plan.warnings.push_back(
        "the search met its bound on memory before it was done; a plan that costs less may exist");
  }
  return plan;
}

/// A plan on grids of one reach and whether a larger reach may do better.
struct Attempt {
  Result<Plan> plan;
  bool wider_may_help{false};
};

Attempt plan_within(GridReach reach, const ocean::Environment& environment, const PlanRequest& request,
                    const std::stop_token& stop, const core::ProgressCallback& progress) {
  progress("environment", 0.0);
  const Result<Chart> chart = draw_chart(environment, request, reach, stop);
  if (!chart) return {tl::unexpected(chart.error())};
  const Sea& sea = chart->sea;

  CostWay way;
  if (request.method == Method::direct) {
    way.route = best_straight_way(sea, chart->layout, request.objective(), stop);
  } else {
    const auto report = [&](double fraction) { progress("search", 0.1 + 0.6 * fraction); };
    const std::vector<OpenGrid> grids = open_grids(sea, chart->layout.grids, request.sectors, stop);
    auto found = search_least_cost(sea, grids, request, at_departure, stop, report);
    if (!found) {
      const bool cancelled = found.error().reason == Reason::cancelled;
      return {tl::unexpected(std::move(found.error())), !cancelled};
    }
    way = std::move(*found);
  }
  progress("refinement", 0.7);
  const DrivenRoute route = improve(sea, way.route, request, stop);
  if (stop.stop_requested()) return {tl::unexpected(explain_cancelled(request))};
  return {publish(*chart, environment, request, route, way.statistics, stop), way.touches_rim};
}

/// The same request for the fastest plan, on each drive by itself.
std::vector<PlanRequest> fastest_requests(const PlanRequest& request) {
  std::vector<PlanRequest> requests;
  for (const vehicle::Drive drive : drives(request.energy, request.vehicle)) {
    PlanRequest fastest = request;
    fastest.optimality_gap = false;
    fastest.energy.objective = time_objective;
    fastest.energy.thruster = drive == vehicle::Drive::thruster ? ThrusterUse::on : ThrusterUse::off;
    requests.push_back(std::move(fastest));
  }
  return requests;
}

bool costs_less(const Result<Plan>& a, const Result<Plan>& b, const Objective& objective) {
  return a && (!b || cost_of(*a, objective) < cost_of(*b, objective));
}

}  // namespace

Result<Plan> publish_straight_way(const Chart& chart, const ocean::Environment& environment,
                                  const PlanRequest& request, const std::stop_token& stop) {
  DrivenRoute route = best_straight_way(chart.sea, chart.layout, request.objective(), stop);
  if (request.max_leg) route = part_long_legs(chart.sea, route, *request.max_leg);
  return publish(chart, environment, request, route, {}, stop);
}

Result<Plan> search_least_cost_plan(const ocean::Environment& environment, const PlanRequest& request,
                                    const std::stop_token& stop, const core::ProgressCallback& progress) {
  // Only the fastest plans wait.
  PlanRequest on_the_move = request;
  on_the_move.max_loiter = core::Seconds{0.0};
  Attempt attempt = plan_within(first_reach, environment, on_the_move, stop, progress);
  if (!attempt.wider_may_help) return std::move(attempt.plan);
  Attempt wider = plan_within(second_reach, environment, on_the_move, stop, progress);
  const bool is_better =
      costs_less(wider.plan, attempt.plan, request.objective()) || (!attempt.plan && !wider.plan);
  return std::move(is_better ? wider.plan : attempt.plan);
}

Result<Plan> plan_least_cost(const ocean::Environment& environment, const PlanRequest& request,
                             const std::stop_token& stop, const core::ProgressCallback& progress,
                             const core::SteadyClock& clock) {
  Result<Plan> best = search_least_cost_plan(environment, request, stop, progress);
  progress("comparison", 0.8);
  for (const PlanRequest& fastest : fastest_requests(request)) {
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    Result<Plan> other = plan_fastest(environment, fastest, stop, [](std::string_view, double) {}, clock);
    if (costs_less(other, best, request.objective())) best = std::move(other);
  }
  if (best && request.optimality_gap) best->optimality_gap_reason = no_gap;
  progress("done", 1.0);
  return best;
}

}  // namespace floeplan::planning
