#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::plane {

/// The point on the straight line from a to b at this share of its length. Shares below 0 and above 1 give
/// points beyond the ends.
[[nodiscard]] inline geo::PlanePoint place_between(geo::PlanePoint a, geo::PlanePoint b, double share) {
  return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
}

/// The point where the move from a to b crosses the line from c to d, as a share of the move; empty if it does not
/// cross. For two lines that meet in a corner, the corner lies on the same side of the move. So a move past the
/// corner crosses both lines or neither.
[[nodiscard]] inline std::optional<double> crossing(geo::PlanePoint a, geo::PlanePoint b, geo::PlanePoint c,
                                                    geo::PlanePoint d) {
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  const double side_c = dx * (c.y_m - a.y_m) - dy * (c.x_m - a.x_m);
  const double side_d = dx * (d.y_m - a.y_m) - dy * (d.x_m - a.x_m);
  if ((side_c > 0.0) == (side_d > 0.0)) return std::nullopt;
  const double ex = d.x_m - c.x_m;
  const double ey = d.y_m - c.y_m;
  const double share = ((c.x_m - a.x_m) * ey - (c.y_m - a.y_m) * ex) / (dx * ey - dy * ex);
  if (share < 0.0 || share > 1.0) return std::nullopt;
  return share;
}

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
