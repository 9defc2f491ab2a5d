#include "engine/planning/planner/strategies.hpp"

#include <algorithm>
#include <utility>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/planner/cost_plan.hpp"
#include "engine/planning/planner/robust_plan.hpp"
#include "engine/planning/planner/strategy_plans.hpp"
#include "engine/planning/planner/strong_currents.hpp"

namespace floeplan::planning::planner {
namespace {

/// Plans on the usual grids, and on more grids if currents are as fast as the vehicle.
Result<Plan> plan_on_more_grids(const Task& task, const Planning& rest) {
  const double share = share_of_usual_grids(task.environment, task.request, task.stop);
  const core::ProgressCallback usual = core::part_of(task.progress, "", 0.0, share);
  const core::ProgressCallback more = core::part_of(task.progress, "", share, 1.0);
  return best_of_more_grids(rest(task.telling(usual)), task.telling(more), rest);
}

bool is_uncertain(const Task& task) { return cost::has_uncertain_currents(task.environment, task.request); }

bool asks_for_members(const Task& task) {
  const UncertaintyRules& rules = task.request.uncertainty;
  return rules.objective != RobustObjective::none || rules.arrive_before || rules.drawn_members > 0;
}

/// Plans, and adds messages about requests for members that have no effect.
Result<Plan> plan_and_tell_of_members(const Task& task, const Planning& rest) {
  Result<Plan> plan = rest(task);
  if (!plan) return plan;
  const UncertaintyRules& rules = task.request.uncertainty;
  if (rules.drawn_members > 0 && task.environment.members.size() > 1)
    plan->messages.push_back(messages::plan_message<"named-members-not-used">());
  const bool asks_for_chances = rules.objective != RobustObjective::none || rules.arrive_before;
  if (asks_for_chances && !is_uncertain(task))
    plan->messages.push_back(messages::plan_message<"uncertainty-without-members">());
  return plan;
}

bool may_surface_more_often(const Task& task) { return task.request.under_ice.escape_plan; }

/// Used if some waypoint of the plan has no escape route. Routes with shorter times between surfacings mostly
/// have one.
Result<Plan> plan_surfacing_more_often(const Task& task, const Planning& rest) {
  core::PartsOfProgress parts{task.progress, "", core::PartsOfProgress::mostly_one};
  const core::ProgressCallback first = parts.next();
  Result<Plan> best = rest(task.telling(first));
  if (best || best.error().reason != Reason::no_escape) return best;
  const core::Seconds until_there = best.error().when - task.request.depart;
  const core::Seconds bound =
      std::min(task.request.under_ice.max_time_without_surfacing.value_or(until_there), until_there);
  for (const double share : {0.5, 0.25}) {
    PlanRequest tighter = task.request;
    tighter.under_ice.max_time_without_surfacing = share * bound;
    if (!tighter.violations().empty()) break;
    const core::ProgressCallback part = parts.next();
    Result<Plan> plan = rest(task.with(tighter).telling(part));
    if (!plan && plan.error().reason == Reason::cancelled) return plan;
    if (!plan && plan.error().reason == Reason::no_escape) continue;
    if (!plan) break;  // no route surfaces this often, so a tighter limit cannot help either
    plan->messages.push_back(messages::plan_message<"surfaces-more-often">());
    return plan;
  }
  return best;
}

/// Each row: its name, when it applies, and the function that plans with the rows below.
constexpr Strategy strategies[] = {
    // Currents as fast as the vehicle: plan on other grids, with more directions and with more room.
    {"more grids", [](const Task& task) { return task.request.method != Method::direct; },
     plan_on_more_grids},
    // Via points in any order: plan the orders with the earliest estimated arrival.
    {"order of visits", [](const Task& task) { return task.request.via_in_best_order; }, plan_survey},
    // The request asks for members: the rows below plan; add messages if the request has no effect.
    {"word on the members", asks_for_members, plan_and_tell_of_members},
    // No escape route: plan with tighter limits on the time without surfacing.
    {"more surfacings", may_surface_more_often, plan_surfacing_more_often},
    // The currents are several forecasts (members): plan in each of them.
    {"members", is_uncertain, plan_uncertain},
    // A weight on encounters with icebergs: plan without it and with it.
    {"fewer encounters", [](const Task& task) { return task.request.objective().of_encounters != 0.0; },
     plan_with_fewer_encounters},
    // Energy counts: make the fastest plan with each propulsion, and search for the least cost.
    {"least cost", [](const Task& task) { return !task.request.energy.objective.is_time(); },
     plan_least_cost},
    {"fastest", [](const Task&) { return true; }, plan_fastest},
};

}  // namespace

std::span<const Strategy> all_strategies() { return strategies; }

Result<Plan> plan_by(std::span<const Strategy> strategies, const Task& task) {
  const auto first =
      std::ranges::find_if(strategies, [&](const Strategy& each) { return each.applies(task); });
  const auto rest = strategies.subspan(static_cast<std::size_t>(first - strategies.begin()) + 1);
  return first->plan(task, [rest](const Task& other) { return plan_by(rest, other); });
}

Result<Plan> try_to_plan(const ocean::Environment& environment, const PlanRequest& request,
                         const std::stop_token& stop, const core::ProgressCallback& report,
                         const core::Executor& executor, std::span<const geo::LonLat> known_route) {
  throw_if_invalid(request);
  const core::ProgressCallback progress = report ? report : [](std::string_view, double) {};
  cost::SeaShelf shelf;
  return plan_by(
      all_strategies().subspan(1),
      {environment, request, stop, progress, {}, shelf, executor, core::Seconds{INFINITY}, known_route});
}

}  // namespace floeplan::planning::planner
