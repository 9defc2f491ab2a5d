#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/planning/refinement/thinning.hpp"

namespace floeplan::planning::refinement {

/// Places where one point may replace the neighbours p and q on a route from a to b around an obstacle: where the
/// legs before and after them would meet if extended, and points farther and farther out from the chord.
[[nodiscard]] std::vector<geo::PlanePoint> places_for_both(geo::PlanePoint a, geo::PlanePoint p,
                                                           geo::PlanePoint q, geo::PlanePoint b);

/// The itinerary with one free point in place of two free neighbours: the cheapest choice; empty if all are closed.
template <cost::CostedLeg Leg>
std::optional<cost::Itinerary> merge_two(LegMeter<Leg>& legs, const cost::Itinerary& timed) {
  std::optional<cost::Itinerary> best;
  const auto& points = timed.route.points;
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    if (timed.route.fixed[i] || timed.route.fixed[i + 1]) continue;
    for (const geo::PlanePoint place :
         places_for_both(points[i - 1], points[i], points[i + 1], points[i + 2])) {
      const auto to = legs(points[i - 1], place, timed.times[i - 1]);
      if (!to || !legs(place, points[i + 2], timed.times[i - 1] + to->time)) continue;
      cost::Route shorter = timed.route;
      shorter.points[i] = place;
      shorter.points.erase(shorter.points.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      shorter.fixed.erase(shorter.fixed.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      auto merged = legs.timed(std::move(shorter), timed.times.front());
      if (merged && (!best || merged->cost() < best->cost())) best = std::move(merged);
    }
  }
  return best;
}

/// Removes points as `thin_to` does. If every removal would close the route, pairs of points are merged into
/// one, provided that the route then has at most `most` legs in the end.
template <cost::CostedLeg Leg>
cost::Itinerary shorten_to(LegMeter<Leg>& legs, cost::Itinerary timed, std::size_t most) {
  cost::Itinerary thinned = thin_to(legs, std::move(timed), most);
  cost::Itinerary shorter = thinned;
  while (shorter.route.legs() > most) {
    auto merged = merge_two(legs, shorter);
    if (!merged) return thinned;
    shorter = thin_to(legs, std::move(*merged), most);
  }
  return shorter;
}

}  // namespace floeplan::planning::refinement
