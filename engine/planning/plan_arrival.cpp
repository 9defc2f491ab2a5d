#include "engine/planning/plan_arrival.hpp"

#include <utility>

#include "engine/planning/diagnosis/what_would_help.hpp"
#include "engine/planning/planner/strong_currents.hpp"
#include "engine/planning/planner/wanted_arrival.hpp"

namespace floeplan::planning {

Result<Plan> plan_arrival(const ocean::Environment& environment, const PlanRequest& request,
                          const std::stop_token& stop, const core::ProgressCallback& report,
                          const WiderSea& wider, const core::Executor& executor) {
  throw_if_invalid(request);
  const core::ProgressCallback progress = core::never_falling(report);
  const double share = planner::share_of_usual_grids(environment, request, stop);
  const core::ProgressCallback usual = core::part_of(progress, "", 0.0, share);
  const core::ProgressCallback more = core::part_of(progress, "", share, 1.0);
  Result<Plan> plan = planner::try_to_plan_arrival(environment, request, stop, usual, executor);
  if (!plan && planner::more_room_may_help(plan.error(), environment, request, stop)) {
    const auto roomy = planner::with_more_room(environment, request, wider);
    if (roomy) {
      Result<Plan> in_room = planner::try_to_plan_arrival(roomy->sea, roomy->request, stop, more, executor);
      if (in_room) {
        progress("done", 1.0);
        return in_room;
      }
    }
    plan = tl::unexpected(
        planner::with_area_searched(std::move(plan.error()), roomy ? roomy->request : request));
  }
  if (plan) {
    progress("done", 1.0);
    return plan;
  }
  return tl::unexpected(
      diagnosis::with_what_would_help(environment, request, std::move(plan.error()), stop, progress));
}

}  // namespace floeplan::planning
