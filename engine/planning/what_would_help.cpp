#include "engine/planning/what_would_help.hpp"

#include <cstdio>
#include <optional>
#include <utility>
#include <variant>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/relaxation.hpp"
#include "engine/planning/way_trials.hpp"

namespace floeplan::planning {
namespace {

/// Whether there is a way at all, and where its search stops if not.
Result<Plan> any_plan(const ocean::Environment& environment, const PlanRequest& request,
                      const std::stop_token& stop) {
  PlanRequest plain = request;
  plain.energy.objective = time_objective;
  plain.icebergs.encounter_weight = core::Seconds{0.0};
  plain.refine = false;
  plain.optimality_gap = false;
  return try_to_plan(environment, plain, stop, {});
}

/// The first of the moves that helps. Where none does, the goal may be moved to where the search for it came nearest. A stop
/// is tried by a whole plan: what becomes of the request is known then, and few are tried.
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
    const auto plan = any_plan(environment, moved, stop);
    if (arrives(plan)) return move;
    if (!plan && plan.error().moves.empty() && !nearest) nearest = plan.error().at;
  }
  if (!nearest || moves.front().input != "to") return std::nullopt;
  PlanRequest moved = request;
  moved.to = *nearest;
  if (!arrives(any_plan(environment, moved, stop))) return std::nullopt;
  char text[64];
  std::snprintf(text, sizeof text, "move it by %.1f km",
                1e-3 * geo::geodesic_between(request.to, *nearest).length.value);
  return Change{.input = "to", .from = request.to, .to = *nearest, .text = text};
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
