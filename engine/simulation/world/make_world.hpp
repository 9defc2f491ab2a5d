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

/// How the real sea differs from what is known of it.
struct WorldSettings {
  CurrentErrorSettings current_error{};
  /// Fastest turn of an iceberg. An assumption, for no statistics were at hand: a quarter turn in three hours.
  double most_spin_deg_h{30.0};
  core::Metres margin{20'000.0};  // about the route, within which the world is known
  planning::UnderIceRules
      ice{};  // of the plan that is flown: what it takes for open water and for the keels of ice

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// A real sea that agrees with the data of an environment but for the errors of the settings.
/// Frame    about the first place of the route
/// Icebergs each with a form and a draft as likely for what was sighted, on the forecast of its drift and off it by
/// what
///          the current's error carries it over its keel from `begin` on; those that come nowhere near the route are
///          left out
/// Edges    beyond the margin nothing is known of the sea bed, and the ice counts as none
/// Errors   std::invalid_argument for an empty route and for settings with violations
/// Stops    once `stop` is requested the world is incomplete and must not be used
[[nodiscard]] World make_world(const ocean::Environment& environment, std::span<const geo::LonLat> route,
                               core::UtcTime begin, core::UtcTime end, const WorldSettings& settings,
                               std::uint64_t seed, const std::stop_token& stop = {});

}  // namespace floeplan::simulation
