#include "engine/planning/plan_window.hpp"

#include <algorithm>
#include <utility>

#include "engine/planning/diagnosis/what_would_help.hpp"
#include "engine/planning/planner/departure.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/planner/strong_currents.hpp"

namespace floeplan::planning {

namespace {

/// Adds the changes that make the window's first departure possible: these make the whole window possible.
Infeasible what_would_help(const ocean::Environment& environment, const PlanRequest& request, Infeasible why,
                           const std::stop_token& stop, const core::ProgressCallback& progress) {
  why = diagnosis::with_what_would_help(environment, leaving_at(request, request.depart), std::move(why),
                                        stop, progress);
  // A later departure is not offered as a change, because the end of the window is part of the request.
  const auto departs_later = [](const Change& change) { return change.input == "depart"; };
  std::erase_if(why.changes, [&](const Change& change) {
    return departs_later(change) || std::ranges::any_of(change.with, departs_later);
  });
  return why;
}

}  // namespace

WindowPlan plan_window(const ocean::Environment& environment, const PlanRequest& request,
                       const std::stop_token& stop, const core::ProgressCallback& report,
                       const WiderSea& wider, const core::Executor& executor) {
  const core::ProgressCallback progress = core::never_falling(report);
  const double share = planner::share_of_usual_grids(environment, request, stop);
  const core::ProgressCallback usual = core::part_of(progress, "", 0.0, share);
  const core::ProgressCallback more = core::part_of(progress, "", share, 1.0);
  WindowPlan window = planner::try_to_plan_window(environment, request, stop, usual, executor);
  if (window.plan) {
    const planner::Planning plan_once = [](const planner::Task& task) {
      return planner::plan_by(planner::all_strategies().subspan(1), task);
    };
    cost::SeaShelf shelf;
    const PlanRequest best = leaving_at(request, window.plan->departure);
    window.plan = planner::best_of_more_grids(
        std::move(window.plan), {environment, best, stop, more, wider, shelf, executor}, plan_once);
    if (window.plan) progress("done", 1.0);
    return window;
  }
  if (planner::more_room_may_help(window.plan.error(), environment, request, stop)) {
    const auto roomy = planner::with_more_room(environment, request, wider);
    if (roomy) {
      WindowPlan in_room = planner::try_to_plan_window(roomy->sea, roomy->request, stop, more, executor);
      if (in_room.plan) {
        progress("done", 1.0);
        return in_room;
      }
    }
    window.plan = tl::unexpected(
        planner::with_area_searched(std::move(window.plan.error()), roomy ? roomy->request : request));
  }
  window.plan =
      tl::unexpected(what_would_help(environment, request, std::move(window.plan.error()), stop, progress));
  return window;
}

}  // namespace floeplan::planning
