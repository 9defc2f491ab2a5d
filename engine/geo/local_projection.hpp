#pragma once

#include <cmath>
#include <memory>

#include "engine/core/units.hpp"
#include "engine/geo/globe_window.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::geo {

/// A point of the local plane, metres of the plane (not of the ground: see LocalProjection::at).
struct PlanePoint {
  double x_m{};
  double y_m{};

  friend bool operator==(PlanePoint, PlanePoint) = default;
};

/// Metres of the plane. Without std::hypot, which takes longer to guard against squares that no sea's coordinates
/// overflow.
[[nodiscard]] inline double distance_m(PlanePoint a, PlanePoint b) {
  const double dx_m = b.x_m - a.x_m;
  const double dy_m = b.y_m - a.y_m;
  return std::sqrt(dx_m * dx_m + dy_m * dy_m);
}

/// How the plane lies on the ground at one place.
struct PlaneScale {
  double scale{1.0};          // metres of the plane for each metre on the ground, the same in every direction
  core::Radians convergence;  // angle of the plane's y axis from true north, clockwise positive
};

/// Velocity in the axes of the plane, metres of the plane for each second.
struct PlaneVelocity {
  double x_m_s{};
  double y_m_s{};
};

/// Conformal projection of WGS84 onto a plane around a place; the plane's origin is that place.
/// Frame    x roughly east, y roughly north; exact directions by `at`
/// Choice   polar stereographic with the origin's meridian straight where |latitude| >= 60 degrees, Lambert
/// conformal
///          conic with one standard parallel for wide areas between 15 and 60 degrees, transverse Mercator
///          elsewhere
/// Edges    areas may cross the antimeridian and contain the pole of their own hemisphere
/// Threads  const members may be called from several threads at once
/// Source   Snyder 1987, Map Projections: A Working Manual, USGS Prof. Paper 1395 (formulas by GeographicLib)
class LocalProjection {
 public:
  explicit LocalProjection(LonLat origin);

  [[nodiscard]] PlanePoint to_plane(LonLat place) const;
  [[nodiscard]] LonLat to_lon_lat(PlanePoint point) const;
  [[nodiscard]] PlaneScale at(LonLat place) const;
  /// The velocity turned into the axes of the plane and stretched by its scale.
  [[nodiscard]] PlaneVelocity to_plane(VelocityEn velocity, LonLat place) const;
  [[nodiscard]] LonLat origin() const { return origin_; }
  /// Where the plane shows the Earth without a seam and without places at infinity: far more than any area of work.
  [[nodiscard]] GlobeWindow window() const;

  class Formulas;  // which of the three projections; private to the source file

 private:
  LonLat origin_;
  std::shared_ptr<const Formulas> formulas_;  // immutable, so copies may share it
};

}  // namespace floeplan::geo
