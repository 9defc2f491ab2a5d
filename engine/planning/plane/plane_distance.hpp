#pragma once

#include <algorithm>
#include <cmath>

#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::plane {

/// Least distance in the plane from a point to the straight line between a and b, metres of the plane.
[[nodiscard]] inline double distance_to_line(geo::PlanePoint p, geo::PlanePoint a, geo::PlanePoint b) {
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  const double length2 = dx * dx + dy * dy;
  const double along =
      length2 > 0.0 ? std::clamp(((p.x_m - a.x_m) * dx + (p.y_m - a.y_m) * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x_m - (a.x_m + along * dx), p.y_m - (a.y_m + along * dy));
}

}  // namespace floeplan::planning::plane
