#include "engine/planning/planner/try_to_plan.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/planner/cost_plan.hpp"
#include "engine/planning/planner/fastest_plan.hpp"
#include "engine/planning/planner/risk_plan.hpp"
#include "engine/planning/planner/robust_plan.hpp"
#include "engine/planning/planner/survey_plan.hpp"

namespace floeplan::planning::planner {
namespace {

/// The best plan by the objective in the first currents of the environment.
Result<Plan> plan_in_one_sea(const ocean::Environment& environment, const PlanRequest& request,
                             const std::stop_token& stop, const core::ProgressCallback& progress,
                             const core::SteadyClock& clock) {
  const auto without_weight_on_encounters = [&](const PlanRequest& unweighted) {
    return unweighted.energy.objective.is_time()
               ? plan_fastest(environment, unweighted, stop, progress, clock)
               : plan_least_cost(environment, unweighted, stop, progress, clock);
  };
  if (request.objective().of_encounters == 0.0) return without_weight_on_encounters(request);
  return plan_with_fewer_encounters(environment, request, without_weight_on_encounters, stop, progress,
                                    clock);
}

/// Where the best way leaves no escape: ways that come to places to surface more often mostly have one.
Result<Plan> surfacing_more_often(const PlanRequest& request, Infeasible why,
                                  const std::function<Result<Plan>(const PlanRequest&)>& plan_with) {
  const core::Seconds until_there = why.when - request.depart;
  const core::Seconds bound =
      std::min(request.under_ice.max_time_without_surfacing.value_or(until_there), until_there);
  for (const double share : {0.5, 0.25}) {
    PlanRequest tighter = request;
    tighter.under_ice.max_time_without_surfacing = share * bound;
    if (!tighter.violations().empty()) break;
    Result<Plan> plan = plan_with(tighter);
    if (!plan && plan.error().reason == Reason::cancelled) return plan;
    if (!plan && plan.error().reason == Reason::no_escape) continue;
    if (!plan) break;  // no way comes to the surface as often, let alone more often
    plan->messages.push_back(messages::plan_message<"surfaces-more-often">());
    return plan;
  }
  return tl::unexpected(std::move(why));
}

}  // namespace

Result<Plan> try_to_plan(const ocean::Environment& environment, const PlanRequest& request,
                         const std::stop_token& stop, const core::ProgressCallback& report,
                         const core::SteadyClock& clock) {
  throw_if_invalid(request);
  const core::ProgressCallback progress = report ? report : [](std::string_view, double) {};
  if (request.via_in_best_order) {
    const auto plan_in_order = [&](const PlanRequest& ordered) {
      return try_to_plan(environment, ordered, stop, progress, clock);
    };
    return plan_survey(environment, request, plan_in_order, stop, progress);
  }
  const bool is_uncertain = cost::has_uncertain_currents(environment, request);
  PlanRequest in_one_sea = request;
  in_one_sea.optimality_gap = request.optimality_gap && !is_uncertain;
  const auto plan_with = [&](const PlanRequest& asked) {
    const PlanIn in_sea = [&](const ocean::Environment& sea) {
      return plan_in_one_sea(sea, asked, stop, progress, clock);
    };
    return is_uncertain ? plan_uncertain(environment, asked, in_sea, stop, progress) : in_sea(environment);
  };
  Result<Plan> plan = plan_with(in_one_sea);
  if (!plan && plan.error().reason == Reason::no_escape)
    plan = surfacing_more_often(in_one_sea, std::move(plan.error()), plan_with);
  if (plan && is_uncertain && request.optimality_gap) {
    plan->optimality_gap_reason = "the currents are not certain, so that no one way is the best";
  }
  if (plan && request.uncertainty.drawn_members > 0 && environment.members.size() > 1) {
    plan->messages.push_back(messages::plan_message<"named-members-not-used">());
  }
  const bool asks_for_chances =
      request.uncertainty.objective != RobustObjective::none || request.uncertainty.arrive_before;
  if (plan && asks_for_chances && !is_uncertain) {
    plan->messages.push_back(messages::plan_message<"uncertainty-without-members">());
  }
  return plan;
}

}  // namespace floeplan::planning::planner
