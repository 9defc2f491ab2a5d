#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// The least depth on a leg.
struct Shoal {
  core::Metres bed;  // positive down
  geo::LonLat place;
  std::size_t waypoint{};  // end of the leg
};

/// For each waypoint the shoalest place of the leg that ends there, both ends included. Empty at the start,
/// and if the bed is unknown on the whole leg.
/// Accuracy  the bed is sampled every 25 m
[[nodiscard]] std::vector<std::optional<Shoal>> shoals_along(const ocean::Bathymetry& bathymetry,
                                                             const planning::Plan& plan);

/// The shoalest place of `shoals` and of the depths stored at the plan's waypoints; empty if no depth is
/// known.
[[nodiscard]] std::optional<Shoal> shoalest_of(const planning::Plan& plan,
                                               const std::vector<std::optional<Shoal>>& shoals);

/// Text such as "-52.8300, 69.2000".
[[nodiscard]] std::string place_text(geo::LonLat place);

}  // namespace floeplan::mission
