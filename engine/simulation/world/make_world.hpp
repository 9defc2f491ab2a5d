#pragma once

#include <cstdint>
#include <span>
#include <stop_token>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"
#include "engine/simulation/world/current_error_field.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// Differences between the simulated sea and the data on it.
struct WorldSettings {
  CurrentErrorSettings current_error{};
  /// Fastest rotation of an iceberg in degrees per hour. An assumption, because no statistics were found: a
  /// quarter turn in three hours.
  double most_spin_deg_h{30.0};
  core::Metres margin{20'000.0};  // around the route; the world is known inside
  planning::UnderIceRules
      ice{};  // rules of the plan that is flown: they decide what is open water and how deep keels are

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// A simulated sea that agrees with the data of an environment, except for the errors in the settings.
/// Frame    its origin is the first place of the route
/// Icebergs Each has a random shape and draft that fit its sighting. It follows its forecast drift, plus the
/// displacement from `begin` on by the current's error over its keel. Bergs that never come near the route
/// are left out
/// Edges    outside the margin the sea bed is unknown, and there is no ice
/// Errors   std::invalid_argument for an empty route and for settings with violations
/// Stops    once `stop` is requested the world is incomplete and must not be used
[[nodiscard]] World make_world(const ocean::Environment& environment, std::span<const geo::LonLat> route,
                               core::UtcTime begin, core::UtcTime end, const WorldSettings& settings,
                               std::uint64_t seed, const std::stop_token& stop = {});

}  // namespace floeplan::simulation
