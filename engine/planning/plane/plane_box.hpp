#pragma once

#include <algorithm>

#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::plane {

/// Rectangle along the axes of the local plane; metres of the plane.
struct PlaneBox {
  geo::PlanePoint low;
  geo::PlanePoint high;

  friend bool operator==(const PlaneBox&, const PlaneBox&) = default;
  [[nodiscard]] double width_m() const { return high.x_m - low.x_m; }
  [[nodiscard]] double height_m() const { return high.y_m - low.y_m; }
  [[nodiscard]] bool contains(geo::PlanePoint p) const {
    return p.x_m >= low.x_m && p.x_m <= high.x_m && p.y_m >= low.y_m && p.y_m <= high.y_m;
  }
  [[nodiscard]] PlaneBox grown(double margin_m) const {
    return {{low.x_m - margin_m, low.y_m - margin_m}, {high.x_m + margin_m, high.y_m + margin_m}};
  }
  void include(geo::PlanePoint p) {
    low = {std::min(low.x_m, p.x_m), std::min(low.y_m, p.y_m)};
    high = {std::max(high.x_m, p.x_m), std::max(high.y_m, p.y_m)};
  }
  void include(const PlaneBox& other) {
    include(other.low);
    include(other.high);
  }
};

/// Whether the boxes have a point in common.
[[nodiscard]] inline bool overlap(const PlaneBox& a, const PlaneBox& b) {
  return a.low.x_m <= b.high.x_m && b.low.x_m <= a.high.x_m && a.low.y_m <= b.high.y_m &&
         b.low.y_m <= a.high.y_m;
}

}  // namespace floeplan::planning::plane
