#include "engine/planning/what_would_help.hpp"

#include <optional>
#include <utility>
#include <variant>

#include "engine/planning/explanation.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/relaxation.hpp"
#include "engine/planning/way_trials.hpp"

namespace floeplan::planning {
namespace {

/// The first of the moves that helps. Where none does, the goal may be moved to where the search for it came nearest. A
/// stop is tried by a whole plan: what becomes of the request is known then, and few are tried.
std::optional<Change> move_that_helps(const ocean::Environment& environment, const PlanRequest& request,
                                      const std::vector<Change>& moves, const std::stop_token& stop) {
  const auto arrives = [&](const Result<Plan>& plan) {
    const auto& wanted = request.departures.arrive_by;
    return plan && (!wanted || plan->arrival <= *wanted);
  };
  std::optional<geo::LonLat> nearest;
  for (const Change& move : moves) {
    PlanRequest moved = request;
    stop_named(moved, move.input) = std::get<geo::LonLat>(move.to);
    const auto plan = try_to_plan(environment, for_any_way(moved), stop, {});
    if (arrives(plan)) return move;
    if (!plan && plan.error().moves.empty() && !nearest) nearest = plan.error().at;
  }
  if (!nearest || moves.front().input != "to") return std::nullopt;
  PlanRequest moved = request;
  moved.to = *nearest;
  if (!arrives(try_to_plan(environment, for_any_way(moved), stop, {}))) return std::nullopt;
  return move_of("to", request.to, *nearest);
}

}  // namespace

Infeasible with_what_would_help(const ocean::Environment& environment, const PlanRequest& request,
                                Infeasible why, const std::stop_token& stop,
                                const core::ProgressCallback& progress) {
  if (why.reason == Reason::cancelled || !why.changes.empty()) return why;
  if (progress) progress("what would help", 0.95);
  if (!why.moves.empty()) {
    auto move = move_that_helps(environment, request, why.moves, stop);
    if (move) why.changes = {std::move(*move)};
  }
  WayTrials trials{environment, stop};
  // A trial that finds a way for the request as it is tells nothing of what stands in its way.
  if (trials(request) == TrialOutcome::possible) return why;
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
