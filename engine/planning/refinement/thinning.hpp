#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::refinement {

/// Removes free points, each time the one that costs least, until at most `most` legs are left or every removal would
/// close the route. The cost may rise.
template <cost::CostedLeg Leg>
cost::Itinerary thin_to(LegMeter<Leg>& legs, cost::Itinerary timed, std::size_t most) {
  while (timed.route.legs() > most) {
    const auto& points = timed.route.points;
    std::vector<std::pair<double, std::size_t>> losses;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (timed.route.fixed[i]) continue;
      const auto without = legs(points[i - 1], points[i + 1], timed.times[i - 1]);
      if (without) losses.emplace_back(timed.costs[i - 1] + without->cost - timed.costs[i + 1], i);
    }
    std::ranges::sort(losses);
    const bool thinned = std::ranges::any_of(losses, [&](const auto& loss) {
      cost::Route shorter = timed.route;
      const auto at = static_cast<std::ptrdiff_t>(loss.second);
      shorter.points.erase(shorter.points.begin() + at);
      shorter.fixed.erase(shorter.fixed.begin() + at);
      auto result = legs.timed(std::move(shorter), timed.times.front());
      if (result) timed = std::move(*result);  // otherwise the later arrival closes a later leg
      return result.has_value();
    });
    if (!thinned) break;
  }
  return timed;
}

/// The itinerary with the leg to `b`, divided into equal pieces, at its end; empty if a piece is closed.
template <cost::CostedLeg Leg>
std::optional<cost::Itinerary> with_pieces(LegMeter<Leg>& legs, cost::Itinerary until, geo::PlanePoint b,
                                           bool end_is_fixed, int pieces) {
  const geo::PlanePoint a = until.route.points.back();
  for (int k = 1; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    const geo::PlanePoint to =
        k == pieces ? b : geo::PlanePoint{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
    const auto leg = legs(until.route.points.back(), to, until.times.back());
    if (!leg) return std::nullopt;
    until.route.points.push_back(to);
    until.route.fixed.push_back(k == pieces && end_is_fixed);
    until.append(*leg);
  }
  return until;
}

/// Number of pieces of each leg for `wanted` pieces in total, of similar duration.
[[nodiscard]] std::vector<int> count_pieces(const cost::Itinerary& timed, std::size_t wanted);

/// Divides the longest legs until there are `wanted`; the line of the route does not change. A leg whose pieces would
/// be closed stays whole.
template <cost::CostedLeg Leg>
cost::Itinerary split_to(LegMeter<Leg>& legs, const cost::Itinerary& timed, std::size_t wanted) {
  const std::vector<int> pieces = count_pieces(timed, wanted);
  const cost::Route& route = timed.route;
  cost::Itinerary result{{{route.points.front()}, {true}}, {timed.times.front()}, {0.0}};
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const auto cut = [&](int into) {
      return with_pieces(legs, result, route.points[i], route.fixed[i], into);
    };
    auto longer = cut(pieces[i - 1]);
    if (!longer) longer = cut(1);
    if (!longer)
      return timed;  // an error of the integration changed a departure, so that the leg is closed then
    result = std::move(*longer);
  }
  return result;
}

}  // namespace floeplan::planning::refinement
