#include "engine/planning/planner/cost_plan.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/publish/battery_check.hpp"
#include "engine/planning/publish/cost_refinement.hpp"
#include "engine/planning/publish/plan_assembly.hpp"
#include "engine/planning/publish/published_plan.hpp"
#include "engine/planning/refinement/refinement_budget.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/energy/cost_search.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/voyage_grids.hpp"

namespace floeplan::planning::planner {
namespace {

/// A difference of costs or travel times that counts, as a share: plans on grids of different spacings in the same
/// currents differ by about as much. A judgement.
constexpr double much = 0.01;

constexpr const char* no_gap = "only plans for the least time are compared with the best possible route";

/// The route to publish and the results of its refinement.
struct ImprovedDrive {
  cost::DrivenRoute route;
  std::optional<RefinementReport> refinement;
};

cost::DrivenRoute straight_way(const cost::Layout& layout, vehicle::Drive drive) {
  const std::size_t points = layout.points.size();
  return {.points = layout.points,
          .fixed = std::vector<bool>(points, true),
          .drives = std::vector<vehicle::Drive>(points - 1, drive)};
}

/// The straight route from stop to stop, each leg with the propulsion that makes the total cost least. The
/// choice starts once from each propulsion on all legs, because the route may be closed to one of them.
cost::DrivenRoute best_straight_way(const cost::Sea& sea, const cost::Layout& layout,
                                    const Objective& objective, const std::stop_token& stop) {
  cost::DrivenRoute best = straight_way(layout, sea.drives().front());
  double least = INFINITY;
  for (const vehicle::Drive drive : sea.drives()) {
    cost::DrivenRoute route =
        cost::choose_drives(sea, straight_way(layout, drive), objective, cost::at_departure, stop);
    const auto times = cost::drive_along(sea, route, cost::at_departure);
    if (!times || !(times->cost(objective) < least)) continue;
    least = times->cost(objective);
    best = std::move(route);
  }
  return best;
}

/// The refined route; `way` is the route along the grid.
publish::RefinedDrive refined(const cost::Sea& sea, const cost::DrivenRoute& way, const PlanRequest& request,
                              const std::stop_token& stop) {
  const Objective objective = request.objective();
  std::optional<std::size_t> most_legs;
  if (request.max_waypoints) most_legs = static_cast<std::size_t>(*request.max_waypoints) - 1;
  const double legs_per_second =
      refinement::metered_legs_per_second / static_cast<double>(sea.drives().size());
  publish::RefinedDrive result =
      publish::refine_drive(sea, cost::drop_costless_points(sea, way, objective, cost::at_departure, stop),
                            objective, {.most_legs = most_legs, .tolerance = request.leg_tolerance},
                            refinement::refinement_budget(request, legs_per_second, stop));
  if (const auto on_grid = cost::drive_along(sea, way, cost::at_departure)) {
    result.report.before = on_grid->arrivals.back() - cost::at_departure;
    result.report.energy_before = on_grid->energy.total();
  }
  return result;
}

/// Improves the route along the grid before it is published.
ImprovedDrive improve(const cost::Sea& sea, const cost::DrivenRoute& way, const PlanRequest& request,
                      const std::stop_token& stop) {
  const Objective objective = request.objective();
  ImprovedDrive improved{way, std::nullopt};
  if (request.refine && request.method != Method::direct) {
    publish::RefinedDrive moved = refined(sea, way, request, stop);
    improved = {std::move(moved.route), std::move(moved.report)};
  }
  if (request.max_waypoints) {
    const auto most = static_cast<std::size_t>(*request.max_waypoints);
    improved.route = cost::drop_to(sea, improved.route, objective, cost::at_departure, most, stop);
  }
  improved.route = cost::choose_drives(sea, improved.route, objective, cost::at_departure, stop);
  if (request.max_leg) improved.route = cost::part_long_legs(sea.domain(), improved.route, *request.max_leg);
  return improved;
}

Result<Plan> publish(const search::Chart& chart, const ocean::Environment& environment,
                     const PlanRequest& request, const ImprovedDrive& improved,
                     const SearchStatistics& statistics, const std::stop_token& stop) {
  const cost::Sea& sea = chart.sea;
  const cost::DrivenRoute& route = improved.route;
  const auto times = cost::drive_along(sea, route, cost::at_departure);
  if (!times) {
    const cost::RouteClosed closed{.reason = times.error(), .at = route.points.front()};
    return tl::unexpected(search::explain_route(closed, sea, request));
  }
  const cost::Schedule schedule{times->arrivals, std::vector<core::Seconds>(times->arrivals.size())};
  Plan plan = publish::assemble_plan(sea, environment, request, route.points, schedule, route.drives, stop);
  plan.search = statistics;
  plan.refinement = improved.refinement;
  if (plan.refinement) {
    plan.refinement->after = plan.travel_time();
    // The energy of planned surfacings, which the search ignores, is added before and after refinement alike.
    const core::Joules of_surfacings = plan.energy->use.total() - times->energy.total();
    if (plan.refinement->energy_before)
      plan.refinement->energy_before = *plan.refinement->energy_before + of_surfacings;
    plan.refinement->energy_after = plan.energy->use.total();
  }
  if (request.optimality_gap) plan.optimality_gap_reason = no_gap;
  if (auto exceeded = publish::check_battery(plan, request)) return tl::unexpected(std::move(*exceeded));
  if (auto none =
          publish::add_escapes(plan, chart, request, route.points, times->arrivals, route.drives, stop))
    return tl::unexpected(std::move(*none));
  publish::add_messages(plan, request);
  if (statistics.cut_short) {
    plan.messages.push_back(messages::plan_message<"cost-search-cut-short">());
  }
  return plan;
}

/// A plan in a search area of one size, and whether a larger area may allow a better plan.
struct CostAttempt {
  Result<Plan> plan;
  bool wider_may_help{false};
};

/// The steps of planning: search area, search, refinement, published plan.
CostAttempt plan_cost_within(cost::GridReach reach, const Task& task) {
  const auto& [environment, request, stop, progress, wider, shelf, executor, of_use, known_route] = task;
  progress("environment", 0.0);
  const Result<search::Chart> chart = search::draw_chart(environment, request, reach, stop, &shelf);
  if (!chart) return {tl::unexpected(chart.error())};
  const cost::Sea& sea = chart->sea;

  search::CostWay way;
  if (request.method == Method::direct) {
    way.route = best_straight_way(sea, chart->layout, request.objective(), stop);
  } else {
    const auto report = [&](double fraction) { progress("search", 0.1 + 0.6 * fraction); };
    const std::vector<search::OpenGrid> grids =
        search::open_grids(sea, chart->layout.grids, request.sectors, stop);
    auto found = search::search_least_cost(sea, grids, request, cost::at_departure, stop, report);
    if (!found) {
      const bool cancelled = found.error().reason == Reason::cancelled;
      return {tl::unexpected(std::move(found.error())), !cancelled};
    }
    way = std::move(*found);
  }
  // If the search was cut short in this area, it would also be cut short in a larger one.
  const bool wider_may_help = way.touches_rim && !way.statistics.cut_short;
  progress("refinement", 0.7);
  const ImprovedDrive improved = improve(sea, way.route, request, stop);
  if (stop.stop_requested()) return {tl::unexpected(search::explain_cancelled(request))};
  return {publish(*chart, environment, request, improved, way.statistics, stop), wider_may_help};
}

ThrusterUse only(vehicle::Drive drive) {
  return drive == vehicle::Drive::thruster ? ThrusterUse::on : ThrusterUse::off;
}

bool costs_less(const Result<Plan>& a, const Result<Plan>& b, const Objective& objective) {
  return a && (!b || cost_of(*a, objective) < cost_of(*b, objective));
}

/// The plan in the smaller search area; also in the larger one if that may be better.
Result<Plan> plan_on_either_reach(const Task& task) {
  const std::vector<cost::GridReach> to_try = cost::reaches(task.request);
  core::PartsOfProgress parts{task.progress, ""};
  const core::ProgressCallback first = parts.next();
  CostAttempt attempt = plan_cost_within(to_try.front(), task.telling(first));
  if (!attempt.wider_may_help || to_try.size() == 1) return std::move(attempt.plan);
  const core::ProgressCallback second = parts.next();
  CostAttempt wider = plan_cost_within(to_try.back(), task.telling(second));
  const bool is_better =
      costs_less(wider.plan, attempt.plan, task.request.objective()) || (!attempt.plan && !wider.plan);
  return std::move(is_better ? wider.plan : attempt.plan);
}

bool was_cut_short(const Result<Plan>& plan) {
  return plan ? plan->search.cut_short : plan.error().search_cut_short;
}

/// The cheaper of the known plan and the result of a search. If the search was cut short, the plan gets a
/// message.
Result<Plan> better_of(Result<Plan> known, Result<Plan> found, const Objective& objective) {
  if (costs_less(found, known, objective) || !known) {
    const bool is_as_early = known && found->travel_time() <= (1.0 + much) * known->travel_time();
    if (is_as_early && known->search.none_is_earlier) found->search.none_is_earlier = true;
    return found;
  }
  if (was_cut_short(found)) known->messages.push_back(messages::plan_message<"cost-search-cut-short">());
  return known;
}

/// The cheapest result of searches on the request's grids: one with all kinds of propulsion and, if that is
/// cut short, one with each kind alone. The latter are then often better.
Result<Plan> best_on_grids(const Task& task, const std::vector<vehicle::Drive>& alone) {
  const PlanRequest& request = task.request;
  Result<Plan> best = plan_on_either_reach(task);
  if (!was_cut_short(best) || drives(request.energy, request.vehicle).size() == 1) return best;
  for (const vehicle::Drive drive : alone) {
    if (task.stop.stop_requested()) break;
    PlanRequest on_drive = request;
    on_drive.energy.thruster = only(drive);
    Result<Plan> found = plan_on_either_reach(task.with(on_drive).silently());
    if (!costs_less(found, best, request.objective())) continue;
    best = std::move(found);
    if (!was_cut_short(best)) {
      best->search.cut_short = true;
      best->messages.push_back(messages::plan_message<"cost-search-cut-short">());
    }
  }
  return best;
}

}  // namespace

double cost_of(const Plan& plan, const Objective& objective) {
  return objective.cost(plan.travel_time(), plan.energy->use.total(), plan.iceberg_encounters.value_or(0.0));
}

PlanRequest fastest_request(const PlanRequest& request, vehicle::Drive drive) {
  PlanRequest fastest = request;
  fastest.optimality_gap = false;
  fastest.energy.objective = time_objective;
  fastest.energy.thruster = only(drive);
  return fastest;
}

Result<Plan> publish_straight_way(const search::Chart& chart, const ocean::Environment& environment,
                                  const PlanRequest& request, const std::stop_token& stop) {
  cost::DrivenRoute route = best_straight_way(chart.sea, chart.layout, request.objective(), stop);
  if (request.max_leg) route = cost::part_long_legs(chart.sea.domain(), route, *request.max_leg);
  return publish(chart, environment, request, {std::move(route), std::nullopt}, {}, stop);
}

Result<Plan> search_least_cost_plan(const KnownPlan& known, const Task& task) {
  const auto& [environment, request, stop, progress, wider, shelf, executor, of_use, known_route] = task;
  // A search for the least cost plans no holds; only a search for the fastest plan does.
  PlanRequest on_the_move = request;
  on_the_move.holds.longest = core::Seconds{0.0};
  const Objective objective = request.objective();
  // A search with larger steps takes a third of the time or less, and refinement makes up for the steps. But
  // large steps may close passages that the known plan uses. So a coarse result that costs much more than the
  // known plan does not count.
  const bool may_be_coarse =
      known.plan && request.refine && request.method != Method::direct && !request.spacing_along;
  Result<Plan> best = known.plan;
  core::PartsOfProgress parts{progress, ""};
  if (may_be_coarse) {
    const core::ProgressCallback on_coarser = parts.next();
    const PlanRequest coarser = cost::on_coarser_grids(on_the_move);
    Result<Plan> coarse = best_on_grids(task.with(coarser).telling(on_coarser), known.on_drives);
    const bool is_near =
        coarse && cost_of(*coarse, objective) <= (1.0 + much) * cost_of(*known.plan, objective);
    const bool is_evidence = is_near || was_cut_short(coarse);  // a finer grid would be cut short, too
    if (is_evidence && !stop.stop_requested()) return better_of(known.plan, std::move(coarse), objective);
    if (costs_less(coarse, best, objective)) best = std::move(coarse);
  }
  if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
  const std::vector<vehicle::Drive> none;
  const core::ProgressCallback on_its_own = parts.next();
  Result<Plan> found =
      best_on_grids(task.with(on_the_move).telling(on_its_own), may_be_coarse ? none : known.on_drives);
  if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
  return better_of(std::move(best), std::move(found), objective);
}

Result<Plan> plan_least_cost(const Task& task, const Planning& plan_fastest) {
  const PlanRequest& request = task.request;
  KnownPlan fastest{.plan = tl::unexpected(Infeasible{}), .on_drives = {}};
  core::PartsOfProgress parts{task.progress, ""};
  for (const vehicle::Drive drive : drives(request.energy, request.vehicle)) {
    if (task.stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
    const core::ProgressCallback part = parts.next();
    const PlanRequest on_drive = fastest_request(request, drive);
    Result<Plan> plan = plan_fastest(task.with(on_drive).telling(part));
    if (plan) fastest.on_drives.push_back(drive);
    if (costs_less(plan, fastest.plan, request.objective())) fastest.plan = std::move(plan);
  }
  const core::ProgressCallback part = parts.next();
  Result<Plan> best = search_least_cost_plan(fastest, task.telling(part));
  if (best && request.optimality_gap) best->optimality_gap_reason = no_gap;
  if (best) task.progress("done", 1.0);
  return best;
}

}  // namespace floeplan::planning::planner
