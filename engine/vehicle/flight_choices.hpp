#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::vehicle {

/// What a pilot sets from mission to mission, whatever the vehicle is; empty: as its profile has it.
struct FlightChoices {
  std::optional<core::MetresPerSecond> speed_through_water{};
  std::optional<core::Radians> pitch{};
  std::optional<core::Metres> climb_to{};
  std::optional<core::Metres> dive_depth{};
  std::optional<core::Metres> altimeter_margin{};
  std::optional<core::Joules> battery{};
  std::optional<double> battery_start_share{};
};

/// The profile with these; its speed stays where the choices name none.
[[nodiscard]] GliderProfile with_choices(GliderProfile profile, const FlightChoices& choices);

/// The profile at the speed of its steady glide; as it is where its pitch carries none.
[[nodiscard]] GliderProfile at_speed_of_glide(GliderProfile profile);

/// Whether all but what may be chosen is as in the known profile of the same name.
[[nodiscard]] bool is_known_but_for_choices(const GliderProfile& profile);

}  // namespace floeplan::vehicle
