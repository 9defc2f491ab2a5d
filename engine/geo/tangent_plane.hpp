#pragma once

#include <array>
#include <optional>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// A direction from the centre of the Earth, as a vector of length one. It has no seam, unlike longitudes.
struct UnitVector {
  double x{};
  double y{};
  double z{};
};

[[nodiscard]] UnitVector unit_vector(LonLat place);
[[nodiscard]] LonLat lon_lat(UnitVector direction);
[[nodiscard]] double dot(UnitVector a, UnitVector b);
/// The place half-way between two places; valid also across the date line and the pole.
[[nodiscard]] LonLat midpoint(LonLat a, LonLat b);
/// Distance on a sphere of the Earth's mean radius, metres; within 0.6 % of that on the ellipsoid.
[[nodiscard]] double sphere_distance_m(LonLat a, LonLat b);

/// Direction of the line from one place to another at the half-way point `at`, in radians counterclockwise
/// from east.
/// Outside  nullopt if both are the same place
[[nodiscard]] std::optional<double> direction_at(LonLat at, LonLat from, LonLat to);

/// Angle in radians, clockwise, by which a direction's bearing grows when it is carried along the great
/// circle from one place to another: meridians converge, so east differs between places.
/// Source  Napier's analogies for the triangle with the pole
[[nodiscard]] double convergence(LonLat from, LonLat to);

/// The plane that touches the Earth at a place; unit of length: the Earth's radius.
class TangentPlane {
 public:
  struct Point {
    double x{};
    double y{};
  };

  explicit TangentPlane(UnitVector at);
  /// Gnomonic projection: great circles become straight lines. Only for directions on the same side of the
  /// Earth as the place.
  [[nodiscard]] Point project(UnitVector direction) const;
  [[nodiscard]] bool faces(UnitVector direction) const { return dot(at_, direction) > 0.1; }

 private:
  UnitVector at_;
  UnitVector e1_;
  UnitVector e2_;
};

}  // namespace floeplan::geo
