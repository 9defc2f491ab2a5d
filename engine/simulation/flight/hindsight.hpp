#pragma once

#include <optional>
#include <stop_token>

#include "engine/core/units.hpp"
#include "engine/simulation/flight/flight_record.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// How a vehicle that knew everything could have moved, seen from above.
struct ForesightSettings {
  core::Metres sonar_range{200.0};
  core::MetresPerSecond through_water{0.35};  // horizontal
  core::Metres turn_radius{15.0};             // 7 m with the rudder hard over, and the lag of hull and rudder
  core::Metres shallowest{5.0};               // of the saw-tooth
  core::Metres deepest{200.0};
  core::Metres hull_reach{0.75};
};

/// Whether a flight that ended at a body, the ice or the sea bed could have been saved by full knowledge from the first
/// moment at which its sonar could have had an echo of what it touched: when that came within the sonar's range, in
/// whatever direction.
/// Model    the vehicle turns at once to any of 36 headings and, after one, three or six minutes, to a second one; it
///          is saved when it meets nothing for 20 minutes from then on. Bodies are met at any depth of the saw-tooth,
///          the sea bed where it is shoaler than the top of it. The vehicle is carried by the true current
/// Returns  empty for a flight that touched nothing; false where no such way is clear, and where nothing was within
///          range before the contact
/// Stops    with false once `stop` is requested
[[nodiscard]] std::optional<bool> could_be_saved(const World& world, const FlightRecord& record,
                                                 const ForesightSettings& settings,
                                                 const std::stop_token& stop = {});

}  // namespace floeplan::simulation
