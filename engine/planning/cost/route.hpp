#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/cost/leg_cost.hpp"

namespace floeplan::planning::cost {

/// A route of straight legs and which of its points must stay.
struct Route {
  std::vector<geo::PlanePoint> points;
  std::vector<bool> fixed;  // start, goal and vias

  [[nodiscard]] std::size_t legs() const { return points.size() - 1; }
};

/// The times of a voyage count from its departure.
inline constexpr core::Seconds at_departure{0.0};

/// A route all of whose points must stay.
[[nodiscard]] inline Route fixed_route(std::vector<geo::PlanePoint> points) {
  const std::size_t count = points.size();
  return {std::move(points), std::vector<bool>(count, true)};
}

/// An open route with the time at each of its points, the departure first, and what it has cost until there.
struct Itinerary {
  Route route;
  std::vector<core::Seconds> times;
  std::vector<double> costs;

  /// One leg more.
  void append(const LegCost& leg) {
    times.push_back(times.back() + leg.time);
    costs.push_back(costs.back() + leg.cost);
  }
  [[nodiscard]] double cost() const { return costs.back(); }
  [[nodiscard]] core::Seconds arrival() const { return times.back(); }
  [[nodiscard]] core::Seconds travel_time() const { return times.back() - times.front(); }
};

/// Leaves out points within `nearby` of the one before them: a leg without length says nothing. Fixed points stay.
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
