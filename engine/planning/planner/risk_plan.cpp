#include <utility>

#include "engine/planning/planner/cost_plan.hpp"
#include "engine/planning/planner/strategy_plans.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::planner {

Result<Plan> plan_with_fewer_encounters(const Task& task, const Planning& plan_unweighted) {
  const PlanRequest& request = task.request;
  PlanRequest unweighted = request;
  unweighted.icebergs.encounter_weight = core::Seconds{0.0};
  core::PartsOfProgress parts{task.progress, ""};
  const core::ProgressCallback first = parts.next();
  Result<Plan> before = plan_unweighted(task.with(unweighted).telling(first));
  if (!before) return before;
  const Objective objective = request.objective();
  EncounterTrade trade{.weight = request.icebergs.encounter_weight,
                       .time_before = before->travel_time(),
                       .encounters_before = before->iceberg_encounters.value_or(0.0)};
  Plan chosen = std::move(*before);
  if (trade.encounters_before > 0.0 && request.method != Method::direct) {
    const core::ProgressCallback second = parts.next();
    second("encounters", 0.0);
    const KnownPlan known{.plan = chosen, .on_drives = drives(request.energy, request.vehicle)};
    Result<Plan> weighted = search_least_cost_plan(known, task.telling(second));
    if (task.stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
    const bool fewer = weighted && weighted->iceberg_encounters.value_or(0.0) <= trade.encounters_before;
    if (fewer && cost_of(*weighted, objective) < cost_of(chosen, objective)) chosen = std::move(*weighted);
  }
  chosen.encounter_trade = trade;
  task.progress("done", 1.0);
  return chosen;
}

}  // namespace floeplan::planning::planner
