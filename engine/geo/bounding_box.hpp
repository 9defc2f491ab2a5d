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

/// How far the box reaches eastwards from its western edge, in (0, 360]; 0 for a meridian.
[[nodiscard]] double width_deg(const BoundingBox& box);

[[nodiscard]] bool contains(const BoundingBox& box, LonLat place);
[[nodiscard]] bool intersects(const BoundingBox& a, const BoundingBox& b);

/// Smallest box around the places (across the antimeridian if that is shorter).
/// Errors   std::invalid_argument without any place
[[nodiscard]] BoundingBox bounding_box(std::span<const LonLat> places);

/// The box grown by a distance on every side; reaches round the globe where a pole comes inside.
[[nodiscard]] BoundingBox grown(const BoundingBox& box, core::Metres margin);

/// The smallest box that holds both.
[[nodiscard]] BoundingBox united(const BoundingBox& a, const BoundingBox& b);

/// The place of the box whose longitude and latitude are nearest to those of `place`, which it is where the box holds it.
[[nodiscard]] LonLat nearest_place(const BoundingBox& box, LonLat place);

/// The box in words, rounded to four digits: "54 W to 50 W, 68 N to 70 N".
[[nodiscard]] std::string bounds_text(const BoundingBox& box);

/// The least box round this one whose edges are whole multiples of `step_deg`, which divides 90 evenly.
[[nodiscard]] BoundingBox on_lattice(const BoundingBox& box, double step_deg);

}  // namespace floeplan::geo
