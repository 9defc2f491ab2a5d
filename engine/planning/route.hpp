#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::planning {

/// A route of straight legs and which of its points must stay.
struct Route {
  std::vector<geo::PlanePoint> points;
  std::vector<bool> fixed;  // start, goal and vias

  [[nodiscard]] std::size_t legs() const { return points.size() - 1; }
};

/// An open route with the time at each of its points, the departure first.
struct Itinerary {
  Route route;
  std::vector<core::Seconds> times;

  [[nodiscard]] core::Seconds arrival() const { return times.back(); }
  [[nodiscard]] core::Seconds travel_time() const { return times.back() - times.front(); }
};

}  // namespace floeplan::planning
