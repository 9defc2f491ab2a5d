#include "engine/planning/diagnosis/what_would_help.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/diagnosis/paired_changes.hpp"
#include "engine/planning/diagnosis/relaxation.hpp"
#include "engine/planning/diagnosis/way_trials.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/planner/strong_currents.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/missing_data.hpp"

namespace floeplan::planning::diagnosis {
namespace {

/// The first of the moves that helps. If none helps, the goal is moved to the nearest place that the search
/// reached. Each move is tested by a complete plan, so the answer is certain; there are only a few moves.
std::optional<Change> move_that_helps(const ocean::Environment& environment, const PlanRequest& request,
                                      const std::vector<Change>& moves, const std::stop_token& stop) {
  const auto arrives = [&](const Result<Plan>& plan) {
    const auto& wanted = request.departures.arrive_by;
    return plan && (!wanted || plan->arrival <= *wanted);
  };
  // Another goal helps only if it leads at least half of the way to the requested goal. A judgement.
  const auto leads_on = [&](geo::LonLat goal) {
    const geo::LonLat before = request.via.empty() ? request.from : request.via.back();
    const auto to_goal_m = [&](geo::LonLat place) {
      return geo::geodesic_between(place, request.to).length.value;
    };
    return to_goal_m(goal) <= 0.5 * to_goal_m(before);
  };
  std::optional<geo::LonLat> nearest;
  for (const Change& move : moves) {
    PlanRequest moved = request;
    stop_named(moved, move.input) = std::get<geo::LonLat>(move.to);
    if (!moved.violations().empty()) continue;  // the place of another stop
    if (move.input == "to" && !leads_on(moved.to)) continue;
    const auto plan = planner::try_to_plan(environment, for_any_way(moved), stop, {});
    if (arrives(plan)) return move;
    if (!plan && !plan.error().at_a_stop && !nearest) nearest = plan.error().at;
  }
  if (!nearest || moves.front().input != "to" || !leads_on(*nearest)) return std::nullopt;
  PlanRequest moved = request;
  moved.to = *nearest;
  if (!arrives(planner::try_to_plan(environment, for_any_way(moved), stop, {}))) return std::nullopt;
  return search::move_of("to", request.to, *nearest);
}

/// Whether the data or the request contain this kind of obstacle, and a trial can leave it out.
bool holds_any(Constraint constraint, const ocean::Environment& environment, const PlanRequest& request,
               const std::stop_token& stop) {
  switch (constraint) {
    case Constraint::iceberg: return !environment.icebergs.empty();
    case Constraint::zone: return !environment.zones.empty() || !request.zones.empty();
    case Constraint::ice: return environment.ice != nullptr;
    case Constraint::current:
      return environment.currents && planner::any_current_may_close(*environment.currents, request, stop);
    default: return false;
  }
}

/// The result of a trial without this kind of obstacle. `left`: remaining work, reduced by the work of the
/// trial.
TrialOutcome outcome_without(Constraint constraint, const ocean::Environment& environment,
                             const PlanRequest& request, std::int64_t& left, const std::stop_token& stop) {
  ocean::Environment open = environment;
  PlanRequest asked = request;
  if (constraint == Constraint::iceberg) open.icebergs.clear();
  if (constraint == Constraint::zone) {
    open.zones.clear();
    asked.zones.clear();
  }
  if (constraint == Constraint::ice) {
    open.ice.reset();
    open.further_ice.clear();
  }
  if (constraint == Constraint::current) {
    // The trial without currents keeps the drift of the icebergs, which uses them.
    if (!open.drift_currents) open.drift_currents = open.currents;
    open.currents.reset();
    open.members.clear();
    open.drift_members.clear();
  }
  WayTrials trials{open, stop, left};
  const TrialOutcome outcome = trials(asked);
  left = trials.left();
  return outcome;
}

/// Whether a search over all routes found none. Then the constraint that stopped it need not be the only one.
bool is_of_a_search(const Infeasible& why, const PlanRequest& request) {
  switch (why.reason) {
    case Reason::goal_unreachable:
    case Reason::outside_data:
    case Reason::current_too_strong:
    case Reason::under_ice:
    case Reason::no_surfacing: return request.method != Method::direct && !why.at_a_stop;
    default: return false;
  }
}

/// The first constraint without which a route would be possible; empty if there is none.
struct Removable {
  std::optional<Constraint> constraint{};
  bool cut_short{false};
};

Removable what_else_binds(const ocean::Environment& environment, const PlanRequest& request,
                          const Infeasible& why, std::int64_t left, const std::stop_token& stop) {
  using enum Constraint;
  const bool by_data = why.binding == data_area || why.binding == data_period;
  Removable result;
  for (const Constraint constraint : {iceberg, zone, ice, current}) {
    if (constraint == why.binding || (constraint == current && by_data)) continue;
    if (!holds_any(constraint, environment, request, stop)) continue;
    const TrialOutcome outcome = outcome_without(constraint, environment, request, left, stop);
    if (outcome == TrialOutcome::possible) return {constraint, false};
    if (outcome == TrialOutcome::not_known) result.cut_short = true;
  }
  return result;
}

}  // namespace

Infeasible with_what_would_help(const ocean::Environment& environment, const PlanRequest& request,
                                Infeasible why, const std::stop_token& stop,
                                const core::ProgressCallback& progress) {
  if (why.reason == Reason::cancelled || !why.changes.empty()) return why;
  why = search::with_missing_data(std::move(why), environment, request);
  if (progress) progress("not possible as asked: " + why.explanation(), 0.95);
  // Only the nearest of the possible new places for a stop are tested.
  const bool has_moves = !why.moves.empty();
  if (has_moves) {
    auto move = move_that_helps(environment, request, why.moves, stop);
    if (move) why.changes = {std::move(*move)};
  }
  // If a stop lies outside the data, only another place or more data can help. If it lies on land far from water, only
  // another place can help.
  const bool is_far_inland = why.binding == Constraint::land && !has_moves;
  if (why.at_a_stop && (why.binding == Constraint::data_area || is_far_inland)) {
    why.changes_cut_short = has_moves && why.changes.empty();
    return why;
  }
  WayTrials trials{environment, stop};
  // If a trial finds a route for the unchanged request, trials cannot tell what closes it.
  if (trials(request) == TrialOutcome::possible) return why;
  const auto without_stored_zones = [&](const PlanRequest& asked) {
    ocean::Environment open = environment;
    open.zones.clear();
    return WayTrials{open, stop}(asked);
  };
  const auto changes = [&] {
    return find_changes(
        environment, request, why, [&](const PlanRequest& changed) { return trials(changed); }, stop,
        without_stored_zones);
  };
  FoundChanges found = changes();
  if (found.changes.empty() && is_of_a_search(why, request)) {
    const Removable other = what_else_binds(environment, request, why, trials.left(), stop);
    const bool cut_short = found.cut_short || other.cut_short;
    if (other.constraint) {
      const Infeasible met_last = std::exchange(why, search::explain_removable(why, *other.constraint));
      found = changes();
      // Without currents the trial may cross places where no current is known, such as land. So the currents are named
      // only where a change of them helps.
      if (*other.constraint == Constraint::current && found.changes.empty()) why = met_last;
    }
    found.cut_short = found.cut_short || cut_short;
    if (found.changes.empty()) {
      WayTrials of_pairs{environment, stop, WayTrials::standard_work / 2};
      auto both = change_with_another(
          environment, request, why, [&](const PlanRequest& changed) { return of_pairs(changed); }, stop);
      if (both) found.changes = {*std::move(both)};
    }
  }
  if (stop.stop_requested()) return search::explain_cancelled(request);
  why.changes = std::move(found.changes);
  why.changes_cut_short = found.cut_short || (has_moves && why.changes.empty());
  return why;
}

}  // namespace floeplan::planning::diagnosis
