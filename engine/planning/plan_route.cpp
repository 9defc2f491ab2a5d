#include "engine/planning/plan_route.hpp"

#include <utility>

#include "engine/planning/diagnosis/what_would_help.hpp"
#include "engine/planning/planner/strategies.hpp"

namespace floeplan::planning {

Result<Plan> plan_route(const ocean::Environment& environment, const PlanRequest& request,
                        const std::stop_token& stop, const core::ProgressCallback& report,
                        const WiderSea& wider, const core::Executor& executor) {
  throw_if_invalid(request);
  const core::ProgressCallback progress = core::never_falling(report);
  cost::SeaShelf shelf;
  Result<Plan> plan = planner::plan_by(planner::all_strategies(),
                                       {environment, request, stop, progress, wider, shelf, executor});
  if (plan) {
    progress("done", 1.0);
    return plan;
  }
  return tl::unexpected(
      diagnosis::with_what_would_help(environment, request, std::move(plan.error()), stop, progress));
}

}  // namespace floeplan::planning
