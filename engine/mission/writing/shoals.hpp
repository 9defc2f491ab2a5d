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

/// The least water on a leg.
struct Shoal {
  core::Metres bed;  // its depth, positive down
  geo::LonLat place;
  std::size_t waypoint{};  // that the leg leads to
};

/// For each waypoint the shoalest place of the leg that leads to it, its ends included; empty at the start, and where
/// nothing is known of the bed on the leg.
/// Accuracy  the bed is looked up every 25 m
[[nodiscard]] std::vector<std::optional<Shoal>> shoals_along(const ocean::Bathymetry& bathymetry,
                                                             const planning::Plan& plan);

/// The shoalest place of all, and of the depths that the plan keeps at its waypoints; empty where no depth is known.
[[nodiscard]] std::optional<Shoal> shoalest_of(const planning::Plan& plan,
                                               const std::vector<std::optional<Shoal>>& shoals);

/// "-52.8300, 69.2000"
[[nodiscard]] std::string place_text(geo::LonLat place);

}  // namespace floeplan::mission
