#include "engine/planning/plan_arrival.hpp"

#include <utility>

#include "engine/planning/diagnosis/what_would_help.hpp"
#include "engine/planning/planner/strong_currents.hpp"
#include "engine/planning/planner/wanted_arrival.hpp"

namespace floeplan::planning {

Result<Plan> plan_arrival(const ocean::Environment& environment, const PlanRequest& request,
                          const std::stop_token& stop, const core::ProgressCallback& progress,
                          const WiderSea& wider, const core::Executor& executor) {
  throw_if_invalid(request);
  Result<Plan> plan = planner::try_to_plan_arrival(environment, request, stop, progress, executor);
  if (!plan && planner::more_room_may_help(plan.error(), environment, request, stop)) {
    const auto roomy = planner::with_more_room(environment, request, wider);
    if (roomy) {
      Result<Plan> in_room =
          planner::try_to_plan_arrival(roomy->sea, roomy->request, stop, progress, executor);
      if (in_room) return in_room;
    }
    plan = tl::unexpected(
        planner::with_area_searched(std::move(plan.error()), roomy ? roomy->request : request));
  }
  if (plan) return plan;
  return tl::unexpected(
      diagnosis::with_what_would_help(environment, request, std::move(plan.error()), stop, progress));
}

}  // namespace floeplan::planning
