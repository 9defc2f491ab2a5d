#pragma once

#include <optional>
#include <stop_token>

#include "engine/core/units.hpp"
#include "engine/simulation/flight/flight_record.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// Movement of a vehicle with full knowledge, in the horizontal plane.
struct ForesightSettings {
  core::Metres sonar_range{200.0};
  core::MetresPerSecond through_water{0.35};  // horizontal
  core::Metres turn_radius{15.0};             // 7 m with the rudder hard over, and the lag of hull and rudder
  core::Metres shallowest{5.0};               // upper turn of the saw-tooth
  core::Metres deepest{200.0};
  core::Metres hull_reach{0.75};
};

/// Whether a flight that ended at a body, the ice or the sea bed could have been saved with full knowledge,
/// from the first time at which the sonar could have had an echo of that object: when it came within sonar
/// range, in any direction.
/// Model    The vehicle turns at once to one of 36 headings and, after one, three or six minutes, to a second
///          one. It is saved if it meets nothing in the next 20 minutes. Bodies count at all depths of the
///          saw-tooth, the sea bed where it is shoaler than the upper turn. The true current moves the
///          vehicle
/// Returns  empty for a flight that touched nothing; false if no such evasive route is clear, or if nothing
///          was within range before the contact
/// Stops    with false once `stop` is requested
[[nodiscard]] std::optional<bool> could_be_saved(const World& world, const FlightRecord& record,
                                                 const ForesightSettings& settings,
                                                 const std::stop_token& stop = {});

}  // namespace floeplan::simulation
