#pragma once

#include <cmath>
#include <memory>

#include "engine/core/units.hpp"
#include "engine/geo/globe_window.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::geo {

/// A point of the local plane in metres of the plane, not metres on the ground: see LocalProjection::at.
struct PlanePoint {
  double x_m{};
  double y_m{};

  friend bool operator==(PlanePoint, PlanePoint) = default;
};

/// Distance in metres of the plane. std::hypot would be slower: it guards against overflow, which cannot
/// happen with coordinates on the Earth.
[[nodiscard]] inline double distance_m(PlanePoint a, PlanePoint b) {
  const double dx_m = b.x_m - a.x_m;
  const double dy_m = b.y_m - a.y_m;
  return std::sqrt(dx_m * dx_m + dy_m * dy_m);
}

/// Scale and orientation of the plane at one place.
struct PlaneScale {
  double scale{1.0};          // metres of the plane per metre on the ground, equal in every direction
  core::Radians convergence;  // angle of the plane's y axis from true north, clockwise positive
};

/// Velocity along the axes of the plane, in metres of the plane per second.
struct PlaneVelocity {
  double x_m_s{};
  double y_m_s{};
};

/// Conformal projection of WGS84 onto a plane around a place, which is the plane's origin.
/// Frame    x roughly east, y roughly north; exact directions by `at`
/// Choice   |latitude| >= 60 degrees: polar stereographic, with the origin's meridian straight. Wide areas
///          between 15 and 60 degrees: Lambert conformal conic with one standard parallel. Otherwise
///          transverse Mercator
/// Edges    areas may cross the antimeridian and contain the pole of their own hemisphere
/// Threads  const members may be called from several threads at once
/// Source   Snyder 1987, Map Projections: A Working Manual, USGS Prof. Paper 1395 (formulas by GeographicLib)
class LocalProjection {
 public:
  explicit LocalProjection(LonLat origin);

  [[nodiscard]] PlanePoint to_plane(LonLat place) const;
  [[nodiscard]] LonLat to_lon_lat(PlanePoint point) const;
  [[nodiscard]] PlaneScale at(LonLat place) const;
  /// Rotates the velocity to the axes of the plane and scales it to the plane.
  [[nodiscard]] PlaneVelocity to_plane(VelocityEn velocity, LonLat place) const;
  [[nodiscard]] LonLat origin() const { return origin_; }
  /// The part of the Earth that the plane shows without a seam and without places at infinity: far more than
  /// any area of work.
  [[nodiscard]] GlobeWindow window() const;

  class Formulas;  // one of the three projections; defined in the source file

 private:
  LonLat origin_;
  std::shared_ptr<const Formulas> formulas_;  // immutable, so copies share it
};

}  // namespace floeplan::geo
