#pragma once

#include <optional>

#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::plane {

/// Where the way from a to b crosses the line from c to d, as a share of the way; empty where it does not. A corner's
/// side of the way is the same for both lines that meet in it, so that a way past it crosses both or neither.
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

}  // namespace floeplan::planning::plane
