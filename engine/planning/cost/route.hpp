#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/cost/leg_cost.hpp"

namespace floeplan::planning::cost {

/// A route of straight legs, and which of its points are fixed.
struct Route {
  std::vector<geo::PlanePoint> points;
  std::vector<bool> fixed;  // true for start, goal and via points

  [[nodiscard]] std::size_t legs() const { return points.size() - 1; }
};

/// Times along a route count from its departure.
inline constexpr core::Seconds at_departure{0.0};

/// A route with all points fixed.
[[nodiscard]] inline Route fixed_route(std::vector<geo::PlanePoint> points) {
  const std::size_t count = points.size();
  return {std::move(points), std::vector<bool>(count, true)};
}

/// A route that is open, with the time and the cost so far at each point. The first entry belongs to the
/// departure.
struct Itinerary {
  Route route;
  std::vector<core::Seconds> times;
  std::vector<double> costs;

  /// Adds the time and cost of the next leg.
  void append(const LegCost& leg) {
    times.push_back(times.back() + leg.time);
    costs.push_back(costs.back() + leg.cost);
  }
  [[nodiscard]] double cost() const { return costs.back(); }
  [[nodiscard]] core::Seconds arrival() const { return times.back(); }
  [[nodiscard]] core::Seconds travel_time() const { return times.back() - times.front(); }
};

/// Removes points closer than `nearby` to the point before them: a leg without length has no course. Fixed
/// points stay.
[[nodiscard]] inline Route without_repeats(const Route& route, core::Metres nearby) {
  Route result;
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    const geo::PlanePoint point = route.points[i];
    const bool repeats = i > 0 && geo::distance_m(result.points.back(), point) <= nearby.value;
    if (repeats && !route.fixed[i]) continue;
    if (repeats && !result.fixed.back()) {
      result.points.back() = point;
      result.fixed.back() = true;
      continue;
    }
    result.points.push_back(point);
    result.fixed.push_back(route.fixed[i]);
  }
  return result;
}

}  // namespace floeplan::planning::cost
