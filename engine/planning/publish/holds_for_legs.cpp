#include "engine/planning/publish/holds_for_legs.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/refinement/longer_legs.hpp"

namespace floeplan::planning::publish {
namespace {

struct Candidate {
  cost::Route route;
  core::Seconds arrival;
};

/// Conditions for a hold that replaces legs.
struct Exchange {
  core::Seconds latest_arrival;
  core::Seconds least_held;  // least sum of the holds of the whole route
};

core::Seconds held_in(const cost::Schedule& schedule) {
  return std::accumulate(schedule.waits.begin(), schedule.waits.end(), core::Seconds{0.0});
}

/// A range of points of a route, both ends included.
struct Run {
  std::size_t first;
  std::size_t last;
};

/// Groups consecutive short legs into runs of points.
std::vector<Run> runs_of(std::vector<std::size_t> short_legs) {
  std::ranges::sort(short_legs);
  std::vector<Run> runs;
  for (const std::size_t leg : short_legs) {
    if (runs.empty() || runs.back().last != leg) runs.push_back({leg, leg});
    runs.back().last = leg + 1;
  }
  return runs;
}

/// The route without the free points of a run; point `kept` stays.
cost::Route without(const cost::Route& route, Run run, std::optional<std::size_t> kept) {
  cost::Route left;
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    const bool goes = run.first <= i && i <= run.last && !route.fixed[i] && i != kept;
    if (goes) continue;
    left.points.push_back(route.points[i]);
    left.fixed.push_back(route.fixed[i]);
  }
  return left;
}

/// The earliest route in which one hold replaces legs of the run. It has fewer short legs, holds long enough
/// and arrives in time; empty if there is none.
std::optional<Candidate> with_hold_about(const cost::Sea& sea, const cost::Route& route, Run run,
                                         std::size_t short_legs, const Exchange& exchange) {
  std::optional<Candidate> best;
  const auto consider = [&](std::optional<std::size_t> kept) {
    cost::Route other = without(route, run, kept);
    if (other.points.size() == route.points.size()) return;
    if (refinement::short_legs(other).size() >= short_legs) return;
    const auto schedule = cost::schedule_along(sea, other.points, cost::at_departure);
    if (!schedule || held_in(*schedule) < exchange.least_held) return;
    const core::Seconds arrival = schedule->arrivals.back();
    if (arrival > exchange.latest_arrival || (best && best->arrival <= arrival)) return;
    best = Candidate{std::move(other), arrival};
  };
  consider(std::nullopt);
  for (std::size_t kept = run.first; kept <= run.last; ++kept)
    if (!route.fixed[kept]) consider(kept);
  return best;
}

}  // namespace

cost::Route with_holds_for_short_legs(const cost::Sea& sea, cost::Route route, const std::stop_token& stop) {
  constexpr double most_later = 0.5;  // both are shares of the time on the short legs: judgements
  constexpr double least_held = 0.5;
  if (!cost::holds_may_help(sea)) return route;
  for (bool changed = true; changed && !stop.stop_requested();) {
    const auto schedule = cost::schedule_along(sea, route.points, cost::at_departure);
    if (!schedule) return route;
    const std::vector<std::size_t> too_short = refinement::short_legs(route);
    changed = std::ranges::any_of(runs_of(too_short), [&](const Run& run) {
      const core::Seconds on_short_legs = schedule->arrivals[run.last] - schedule->leaves(run.first);
      const Exchange exchange{schedule->arrivals.back() + most_later * on_short_legs,
                              held_in(*schedule) + least_held * on_short_legs};
      auto held = with_hold_about(sea, route, run, too_short.size(), exchange);
      if (held) route = std::move(held->route);
      return held.has_value();
    });
  }
  return route;
}

}  // namespace floeplan::planning::publish
