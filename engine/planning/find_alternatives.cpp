#include "engine/planning/find_alternatives.hpp"

#include "engine/planning/planner/alternative_plans.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning {

Result<Alternatives> find_alternatives(const ocean::Environment& environment, const PlanRequest& request,
                                       const Plan& plan, const std::stop_token& stop,
                                       const core::ProgressCallback& report, const core::Executor& executor) {
  throw_if_invalid(request);
  if (request.alternatives == 0) return Alternatives{};
  const core::ProgressCallback progress = core::never_falling(report);
  const auto plan_once = [](const planner::Task& task) {
    return planner::plan_by(planner::all_strategies().subspan(1), task);
  };
  cost::SeaShelf shelf;
  Alternatives found =
      planner::alternatives_to(plan, {environment, request, stop, progress, {}, shelf, executor}, plan_once);
  if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
  return found;
}

}  // namespace floeplan::planning
