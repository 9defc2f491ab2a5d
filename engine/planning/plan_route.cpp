#include "engine/planning/plan_route.hpp"

#include <utility>

#include "engine/planning/diagnosis/what_would_help.hpp"
#include "engine/planning/planner/strong_currents.hpp"
#include "engine/planning/planner/try_to_plan.hpp"

namespace floeplan::planning {

Result<Plan> plan_route(const ocean::Environment& environment, const PlanRequest& request,
                        const std::stop_token& stop, const core::ProgressCallback& report,
                        const core::SteadyClock& clock, const WiderSea& wider) {
  const planner::PlanOnce plan_once = [&](const ocean::Environment& sea, const PlanRequest& asked) {
    return planner::try_to_plan(sea, asked, stop, report, clock);
  };
  Result<Plan> plan = planner::best_of_more_grids(plan_once(environment, request), environment, request,
                                                  wider, plan_once, stop);
  if (plan) return plan;
  return tl::unexpected(
      diagnosis::with_what_would_help(environment, request, std::move(plan.error()), stop, report));
}

}  // namespace floeplan::planning
