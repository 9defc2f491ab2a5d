#pragma once

#include <vector>

#include "engine/geo/polygon.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// Areas at most this far apart touch. Two outlines along the same line in longitude and latitude may have
/// different corners. In the plane they then bend differently, by about this distance.
inline constexpr double touching_m = 1.5;

/// A polygon in the plane. Its long edges are divided, because they bend there.
/// Threads  const members may be called from several threads at once
class PlanePolygon {
 public:
  PlanePolygon(const geo::Polygon& polygon, const geo::LocalProjection& projection);

  /// Box around the polygon.
  [[nodiscard]] const PlaneBox& box() const { return box_; }
  [[nodiscard]] bool contains(geo::PlanePoint point) const;
  /// Whether any point of the straight line from a to b lies in the polygon.
  [[nodiscard]] bool meets(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Shares of the line from a to b at which it crosses the outline, in no particular order.
  [[nodiscard]] std::vector<double> crossings(geo::PlanePoint a, geo::PlanePoint b) const;

 private:
  struct Line {
    geo::PlanePoint from;
    geo::PlanePoint to;
  };
  std::vector<Line> lines_;  // of the outer ring and of the holes
  PlaneBox box_;
};

/// Whether every point of the straight line from a to b lies in at least one of the polygons, or where two
/// touch.
[[nodiscard]] bool covered(const std::vector<const PlanePolygon*>& polygons, geo::PlanePoint a,
                           geo::PlanePoint b);

}  // namespace floeplan::planning::plane
