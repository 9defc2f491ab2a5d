#include "engine/planning/planner/robust_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/core/packed_parts.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/ocean/currents/ensemble_mean.hpp"
#include "engine/planning/cost/driven_route.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea_members.hpp"
#include "engine/planning/planner/route_evaluation.hpp"
#include "engine/planning/problem/member_spread.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::planner {
namespace {

/// Work of timing all candidates in one member, for the progress; unit: a whole plan. Measured with the
/// demonstration data: 0.4 s, and 0.9 s for a plan.
constexpr double plans_a_look = 0.4;

std::vector<geo::LonLat> places_of(const Plan& plan) {
  std::vector<geo::LonLat> places;
  places.reserve(plan.waypoints.size());
  for (const Waypoint& waypoint : plan.waypoints) places.push_back(waypoint.place);
  return places;
}

/// The legs of the plan and the propulsion of each. The vehicle uses the same legs and propulsion in every
/// member.
cost::DrivenRoute route_of(const Plan& plan, const geo::LocalProjection& projection) {
  cost::DrivenRoute route;
  for (const Waypoint& waypoint : plan.waypoints) {
    route.points.push_back(projection.to_plane(waypoint.place));
    route.fixed.push_back(true);
    if (waypoint.drive) route.drives.push_back(*waypoint.drive);
  }
  return route;
}

/// Times the plans in one member's environment: first in the smaller search area, then in the larger one if a
/// route leaves the smaller or is closed there. The safety map's cells along the routes are opened, because
/// their cautious rounding must not close a passage that is open in the data.
std::vector<std::optional<cost::DrivenTimes>> drive_all(const ocean::Environment& environment,
                                                        const PlanRequest& request,
                                                        const std::vector<Plan>& plans, cost::SeaShelf& shelf,
                                                        const std::stop_token& stop) {
  std::vector<std::optional<cost::DrivenTimes>> result(plans.size());
  for (const cost::GridReach reach : cost::reaches(request)) {
    if (stop.stop_requested() ||
        std::ranges::all_of(result, [](const auto& times) { return times.has_value(); }))
      break;
    Result<search::Chart> chart = search::draw_chart(environment, request, reach, stop, &shelf);
    if (!chart) continue;
    std::vector<cost::DrivenRoute> routes;
    std::vector<std::vector<geo::PlanePoint>> points;
    for (const Plan& plan : plans) {
      routes.push_back(route_of(plan, chart->layout.projection));
      points.push_back(routes.back().points);
    }
    chart->sea.domain().safety().open_along(points, chart->layout.projection);
    for (std::size_t i = 0; i < plans.size(); ++i) {
      if (result[i]) continue;
      if (auto times = cost::drive_in_time(chart->sea, routes[i], cost::at_departure))
        result[i] = std::move(*times);
    }
  }
  return result;
}

/// The travel times and costs of one route, in each member.
class Fares {
 public:
  /// Adds the result in the next member. Empty: the route is closed there.
  void add(const std::optional<cost::DrivenTimes>& times, const Objective& objective) {
    times_.push_back(times ? std::optional{times->arrivals.back() - cost::at_departure} : std::nullopt);
    costs_.push_back(times ? std::optional{times->cost(objective)} : std::nullopt);
  }

  [[nodiscard]] ArrivalSpread arrivals() const { return ArrivalSpread{times_}; }
  [[nodiscard]] MemberSpread costs() const { return MemberSpread{costs_}; }

 private:
  std::vector<std::optional<core::Seconds>> times_;
  std::vector<std::optional<double>> costs_;
};

UncertaintyReport report_of(const Fares& fares, const UncertaintyRules& rules, core::UtcTime depart,
                            std::size_t candidates) {
  UncertaintyReport report{.spread = fares.arrivals(),
                           .objective = rules.objective,
                           .quantile = rules.quantile,
                           .candidates = candidates,
                           .arrive_before = rules.arrive_before,
                           .chance = {},
                           .costs = fares.costs()};
  if (rules.arrive_before) report.chance = report.spread.chance_within(*rules.arrive_before - depart);
  return report;
}

/// The message about members in which all compared routes are closed; empty if there are none.
std::optional<messages::Message> of_closed_members(const UncertaintyReport& report) {
  const std::size_t members = report.spread.travel_times().size();
  const std::size_t closed = members - report.spread.arrived();
  if (closed == 0 || report.objective == RobustObjective::none) return std::nullopt;
  if (report.objective == RobustObjective::mean)
    return messages::plan_message<"closed-members-left-out-of-mean">(closed, members);
  if (report.spread.quantile(report.quantile))
    return messages::plan_message<"closed-in-members">(closed, members);
  return messages::plan_message<"share-of-members-not-met">(closed, members, 100.0 * report.quantile);
}

}  // namespace

double what_counts(const MemberSpread& costs, const UncertaintyRules& rules) {
  const auto cost =
      rules.objective == RobustObjective::quantile ? costs.quantile(rules.quantile) : costs.mean();
  return cost.value_or(std::numeric_limits<double>::infinity());
}

bool is_better(const MemberSpread& a, const MemberSpread& b, const UncertaintyRules& rules) {
  if (a.known() != b.known()) return a.known() > b.known();
  const double of_a = what_counts(a, rules);
  const double of_b = what_counts(b, rules);
  // If both are open in too few members for the requested share, the lower mean cost over the open members
  // decides.
  if (std::isinf(of_a) && std::isinf(of_b) && a.known() > 0) return *a.mean() < *b.mean();
  return of_a < of_b;
}

core::UtcTime arrival_that_counts(const Plan& plan, const UncertaintyRules& rules) {
  if (!plan.uncertainty || rules.objective == RobustObjective::none) return plan.arrival;
  const ArrivalSpread& spread = plan.uncertainty->spread;
  const auto time =
      rules.objective == RobustObjective::quantile ? spread.quantile(rules.quantile) : spread.mean();
  return plan.departure + time.value_or(core::Seconds{std::numeric_limits<double>::infinity()});
}

Result<Plan> plan_uncertain(const Task& task, const Planning& plan_in_one_sea) {
  const auto& [environment, asked, stop, progress, wider, shelf, executor, of_use, known_route] = task;
  PlanRequest request = asked;
  request.optimality_gap = false;
  const UncertaintyRules& rules = request.uncertainty;
  const cost::SeaMembers members{environment, rules};
  const bool is_robust = rules.objective != RobustObjective::none;
  const bool plans_in_mean = is_robust && rules.drawn_members == 0;
  const std::size_t plans = is_robust ? 1 + members.size() + (plans_in_mean ? 1 : 0) : 1;
  const double work = static_cast<double>(plans) + plans_a_look * static_cast<double>(members.size());
  const auto told = [&](double done) { progress("members", done / work); };
  const auto plan_in = [&](const ocean::Environment& sea, const Task& how) {
    return plan_in_one_sea(how.with(request).in(sea));
  };
  Result<Plan> base = plan_in(environment, task.telling(core::part_of(progress, "members", 0.0, 1.0 / work)));
  if (!base) return base;

  // Further candidates: the best route in the mean of the members may be good in all of them, better than the
  // best route of any one member.
  std::vector<std::optional<Plan>> ways(plans - 1);  // candidates: one per member, then one for the mean
  const auto sea_of = [&](std::size_t way) -> std::optional<ocean::Environment> {
    if (way < members.size()) return members.environment(way);
    auto mean = ocean::ensemble_mean(environment.members);
    if (!mean) return std::nullopt;
    ocean::Environment sea = environment;
    sea.members.clear();
    sea.drift_members.clear();
    sea.currents = std::make_shared<const ocean::CurrentGrid>(std::move(*mean));
    return sea;
  };
  core::CountOfEnded planned{[&](std::size_t ended) { told(static_cast<double>(1 + ended)); }};
  using Places = std::vector<geo::LonLat>;
  std::vector<Places> places(ways.size());  // none where there is no route
  core::run_packed_parts<Places>(
      executor, ways.size(),
      [&](std::size_t way, bool is_caller) -> std::optional<Places> {
        const auto sea = sea_of(way);
        const auto plan = sea ? std::optional{plan_in(*sea, task.as_piece())} : std::nullopt;
        if (stop.stop_requested()) return std::nullopt;
        planned.add(is_caller);
        return plan && *plan ? places_of(**plan) : Places{};
      },
      [&](std::size_t way, Places found, bool elsewhere) {
        places[way] = std::move(found);
        if (elsewhere) planned.add(true);
      });
  // A route that is closed in the currents of the first member cannot be published, because the plan's times are
  // those in these currents.
  {
    cost::SeaShelf beside_routes;  // with areas of their own; freed before the members take memory again
    executor.run(ways.size(), [&](std::size_t way, bool) {
      if (places[way].empty() || stop.stop_requested()) return;
      Result<Plan> in_first = evaluate_in(environment, places[way], request, stop, &beside_routes);
      if (in_first) ways[way] = std::move(*in_first);
    });
  }
  if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
  std::vector<Plan> candidates{*base};
  for (std::optional<Plan>& way : ways)
    if (way) candidates.push_back(std::move(*way));

  const Objective objective = request.objective();
  std::vector<Fares> fares(candidates.size());
  std::vector<std::vector<std::optional<cost::DrivenTimes>>> driven(members.size());
  core::CountOfEnded timed{[&](std::size_t ended) {
    told(static_cast<double>(plans) + plans_a_look * static_cast<double>(ended));
  }};
  executor.run(members.size(), [&](std::size_t member, bool is_caller) {
    driven[member] = drive_all(members.environment(member), request, candidates, shelf, stop);
    timed.add(is_caller);
  });
  for (const auto& in_member : driven)
    for (std::size_t i = 0; i < candidates.size(); ++i) fares[i].add(in_member[i], objective);
  if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));

  std::vector<MemberSpread> costs;
  costs.reserve(fares.size());
  for (const Fares& each : fares) costs.push_back(each.costs());
  std::size_t best = 0;
  for (std::size_t i = 1; i < costs.size(); ++i) {
    if (is_better(costs[i], costs[best], rules)) best = i;
  }
  Plan& chosen = candidates[best];
  chosen.method = base->method;
  chosen.search = base->search;
  chosen.encounter_trade = base->encounter_trade;
  chosen.uncertainty = report_of(fares[best], rules, request.depart, candidates.size());
  if (auto closed = of_closed_members(*chosen.uncertainty)) chosen.messages.push_back(std::move(*closed));
  if (asked.optimality_gap)
    chosen.optimality_gap_reason = "the currents are uncertain, so no single route is the best";
  return std::move(chosen);
}

}  // namespace floeplan::planning::planner
