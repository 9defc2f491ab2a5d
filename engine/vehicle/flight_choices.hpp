#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::vehicle {

/// Settings that a pilot may change from mission to mission, for any vehicle; empty: as in the vehicle's
/// profile.
struct FlightChoices {
  std::optional<core::MetresPerSecond> speed_through_water{};
  std::optional<core::Radians> pitch{};
  std::optional<core::Metres> climb_to{};
  std::optional<core::Metres> dive_depth{};
  std::optional<core::Metres> altimeter_margin{};
  std::optional<core::Joules> battery{};
  std::optional<double> battery_start_share{};
};

/// The profile with these settings. Its speed through the water changes only if the choices give a speed.
[[nodiscard]] GliderProfile with_choices(GliderProfile profile, const FlightChoices& choices);

/// The profile with the speed of its steady glide; unchanged if its pitch allows no steady glide.
[[nodiscard]] GliderProfile at_speed_of_glide(GliderProfile profile);

/// Whether the profile equals the known one of the same name, apart from what FlightChoices may change.
[[nodiscard]] bool is_known_but_for_choices(const GliderProfile& profile);

}  // namespace floeplan::vehicle
