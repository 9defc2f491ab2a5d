#pragma once

#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::plane {

/// The point on the straight line from a to b at this share of its length; shares below 0 and above 1 lie beyond its
/// ends.
[[nodiscard]] inline geo::PlanePoint place_between(geo::PlanePoint a, geo::PlanePoint b, double share) {
  return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
}

}  // namespace floeplan::planning::plane
