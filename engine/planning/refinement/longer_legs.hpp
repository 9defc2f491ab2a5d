#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/planning/refinement/shortening.hpp"

namespace floeplan::planning::refinement {

/// Legs that are too short for a pilot to steer, the shortest first, by the index of their first point. A leg
/// is short below 3 km or a fifth of the distance between the fixed points around it, whichever is less.
/// Source  a judgement
[[nodiscard]] std::vector<std::size_t> short_legs(const cost::Route& route);

/// The itinerary without the leg from point `i`: without one of its ends, or with one point in place of both. The
/// cheapest open choice; empty if all are closed.
template <cost::CostedLeg Leg>
std::optional<cost::Itinerary> without_leg(LegMeter<Leg>& legs, const cost::Itinerary& timed, std::size_t i) {
  const cost::Route& route = timed.route;
  const auto is_free = [&](std::size_t at) { return !route.fixed[at]; };
  std::optional<cost::Itinerary> best;
  const auto consider = [&](std::size_t leave_out, std::optional<geo::PlanePoint> move_other_to) {
    cost::Route other = route;
    if (move_other_to) other.points[i] = *move_other_to;
    other.points.erase(other.points.begin() + static_cast<std::ptrdiff_t>(leave_out));
    other.fixed.erase(other.fixed.begin() + static_cast<std::ptrdiff_t>(leave_out));
    auto result = legs.timed(std::move(other), timed.times.front());
    if (result && (!best || result->cost() < best->cost())) best = std::move(result);
  };
  if (is_free(i)) consider(i, std::nullopt);
  if (is_free(i + 1)) consider(i + 1, std::nullopt);
  if (is_free(i) && is_free(i + 1)) {
    const auto& points = route.points;
    for (const geo::PlanePoint place :
         places_for_both(points[i - 1], points[i], points[i + 1], points[i + 2]))
      consider(i + 1, place);
  }
  return best;
}

/// The itinerary without its short legs, as far as the rest is open and costs no more than `most_cost`.
/// `settle`  moves the points of an itinerary to lower its cost, with the same number of legs
template <cost::CostedLeg Leg, class Settle>
cost::Itinerary without_short_legs(LegMeter<Leg>& legs, cost::Itinerary timed, double most_cost,
                                   const Settle& settle) {
  for (;;) {
    const std::vector<std::size_t> too_short = short_legs(timed.route);
    const bool changed = std::ranges::any_of(too_short, [&](std::size_t i) {
      auto longer = without_leg(legs, timed, i);
      if (!longer) return false;
      cost::Itinerary settled = settle(*longer);
      const bool settled_is_better = settled.cost() <= most_cost &&
                                     (longer->cost() > most_cost ||
                                      short_legs(settled.route).size() <= short_legs(longer->route).size());
      if (!settled_is_better && longer->cost() > most_cost) return false;
      timed = settled_is_better ? std::move(settled) : std::move(*longer);
      return true;
    });
    if (!changed) return timed;
  }
}

}  // namespace floeplan::planning::refinement
