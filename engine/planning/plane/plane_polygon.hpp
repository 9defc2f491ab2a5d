#pragma once

#include <vector>

#include "engine/geo/polygon.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// Areas no further apart than this touch: edges that are one line in longitude and latitude but have other corners on
/// it bend otherwise in the plane, by up to about as much.
inline constexpr double touching_m = 1.5;

/// A polygon laid out in the plane, its long edges in pieces because they bend there.
/// Threads  const members may be called from several threads at once
class PlanePolygon {
 public:
  PlanePolygon(const geo::Polygon& polygon, const geo::LocalProjection& projection);

  /// Holds all of it.
  [[nodiscard]] const PlaneBox& box() const { return box_; }
  [[nodiscard]] bool contains(geo::PlanePoint point) const;
  /// Whether any point of the straight line from a to b lies in the polygon.
  [[nodiscard]] bool meets(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Shares of the way from a to b at which it crosses the outline, in no order.
  [[nodiscard]] std::vector<double> crossings(geo::PlanePoint a, geo::PlanePoint b) const;

 private:
  struct Line {
    geo::PlanePoint from;
    geo::PlanePoint to;
  };
  std::vector<Line> lines_;  // of the outer ring and the holes
  PlaneBox box_;
};

/// Whether every point of the straight line from a to b lies in one of the polygons or another, or where two touch.
[[nodiscard]] bool covered(const std::vector<const PlanePolygon*>& polygons, geo::PlanePoint a,
                           geo::PlanePoint b);

}  // namespace floeplan::planning::plane
