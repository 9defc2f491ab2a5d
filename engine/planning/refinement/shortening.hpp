#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/planning/refinement/thinning.hpp"

namespace floeplan::planning::refinement {

/// Places where one point may stand for the neighbours p and q on a way from a to b round what lies between: where the
/// legs that come and go would meet if they went on, and straight out from the chord, further and further.
[[nodiscard]] std::vector<geo::PlanePoint> places_for_both(geo::PlanePoint a, geo::PlanePoint p,
                                                           geo::PlanePoint q, geo::PlanePoint b);

/// The itinerary with one free point in the place of two neighbours that are free, the cheapest of what is tried; empty
/// where all of it is closed.
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

/// As `thin_to`; where no point can go without the route closing, two of them are merged into one that lies elsewhere, if
/// that leads to no more than `most` legs in the end.
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
