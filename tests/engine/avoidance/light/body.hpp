#pragma once

#include <optional>

#include "engine/geo/local_projection.hpp"

namespace floeplan::support {

/// A place in the sea: metres east, north and down.
struct SeaPoint {
  double east_m{};
  double north_m{};
  double depth_m{};
};

/// A simple solid of the light test bed: an ellipsoid, or a box, that drifts and turns about the vertical.
struct Body {
  enum class Shape { ellipsoid, box };

  Shape shape{Shape::ellipsoid};
  SeaPoint centre{};           // at time 0
  SeaPoint half_axes{};        // along the length, across it, and down
  double bearing_rad{};        // of the length, clockwise from north, at time 0
  geo::PlaneVelocity drift{};  // through the water
  double turn_rad_s{};
  bool is_fixed{};  // to the ground: the water flows past it
};

/// The body at a time. `carried`: displacement of the water since time 0.
struct PlacedBody {
  const Body* body{};
  SeaPoint centre{};
  double sin_bearing{};
  double cos_bearing{1.0};
};
[[nodiscard]] PlacedBody placed_at(const Body& body, double time_s, geo::PlanePoint carried);

[[nodiscard]] double reach_m(const Body& body);
/// Whether the point is in the body or nearer than `margin_m` to it along its axes.
[[nodiscard]] bool is_inside(const PlacedBody& placed, const SeaPoint& point, double margin_m);
/// Distance to the point where a ray first enters the body; empty if the ray misses the body. `direction` is
/// a unit vector.
[[nodiscard]] std::optional<double> first_hit(const PlacedBody& placed, const SeaPoint& from,
                                              const SeaPoint& direction);

}  // namespace floeplan::support
