#pragma once

#include <span>
#include <string>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// Part of the globe between two meridians and two parallels, degrees.
/// Edges    west may exceed east: then the box runs across the antimeridian, from west eastwards to east;
///          [-180, 180] is the whole circle
struct BoundingBox {
  double west_deg{};
  double south_deg{};
  double east_deg{};
  double north_deg{};

  friend bool operator==(BoundingBox, BoundingBox) = default;
};

/// Width in degrees, eastwards from the western edge, in (0, 360]; 0 for a single meridian.
[[nodiscard]] double width_deg(const BoundingBox& box);

[[nodiscard]] bool contains(const BoundingBox& box, LonLat place);
[[nodiscard]] bool intersects(const BoundingBox& a, const BoundingBox& b);

/// Smallest box around the places; it crosses the antimeridian if that is shorter.
/// Errors   std::invalid_argument for no places
[[nodiscard]] BoundingBox bounding_box(std::span<const LonLat> places);

/// The box enlarged by a distance on every side; it spans all longitudes if a pole comes inside.
[[nodiscard]] BoundingBox grown(const BoundingBox& box, core::Metres margin);

/// The smallest box that contains both.
[[nodiscard]] BoundingBox united(const BoundingBox& a, const BoundingBox& b);

/// The place in the box with the nearest longitude and latitude to `place`; `place` itself if it is inside.
[[nodiscard]] LonLat nearest_place(const BoundingBox& box, LonLat place);

/// Text for the box, rounded to four digits: "54° W to 50° W, 68° N to 70° N"; "54° W to 50° W, 68° N" if two edges
/// round to the same number.
[[nodiscard]] std::string bounds_text(const BoundingBox& box);

/// The smallest box around this one whose edges are multiples of `step_deg`; 90 must be a multiple of
/// `step_deg`.
[[nodiscard]] BoundingBox on_lattice(const BoundingBox& box, double step_deg);

}  // namespace floeplan::geo
