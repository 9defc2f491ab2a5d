#include "engine/planning/what_would_help.hpp"

#include <utility>

#include "engine/planning/explanation.hpp"
#include "engine/planning/relaxation.hpp"
#include "engine/planning/way_trials.hpp"

namespace floeplan::planning {

Infeasible with_what_would_help(const ocean::Environment& environment, const PlanRequest& request,
                                Infeasible why, const std::stop_token& stop,
                                const core::ProgressCallback& progress) {
  if (why.reason == Reason::cancelled || !why.changes.empty()) return why;
  if (progress) progress("what would help", 0.95);
  WayTrials trials{environment, stop};
  const auto without_stored_zones = [&](const PlanRequest& asked) {
    ocean::Environment open = environment;
    open.zones.clear();
    return WayTrials{open, stop}(asked);
  };
  FoundChanges found = find_changes(
      environment, request, why, [&](const PlanRequest& changed) { return trials(changed); }, stop,
      without_stored_zones);
  if (stop.stop_requested()) return explain_cancelled(request);
  why.changes = std::move(found.changes);
  why.changes_cut_short = found.cut_short;
  return why;
}

}  // namespace floeplan::planning
