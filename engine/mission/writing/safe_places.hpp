#pragma once

#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/message.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::mission {

/// A place to recover to, and what is known of the sea there; of its parts bathymetry, land, ice, icebergs and zones
/// are looked at.
struct SafePlace {
  geo::LonLat place;
  ocean::Environment sea;
};

struct SafePlaceFindings {
  core::Violations violations;              // "/safe/0" and so on
  std::vector<messages::Message> messages;  // what the data do not tell
};

/// Judges the places that a vehicle shall recover to from under ice.
/// Refused   land and water too shallow for the vehicle; ice denser than `max_concentration_to_surface` at some time of
///           the plan, the first and last step of the ice holding for ocean::longest_ice_hold; what the rest of the
///           battery does not reach in still water from any waypoint, at the plan's mean power; a no-go area, at
///           whatever depths and at some time of the plan or after it; a place that an iceberg covered when it was seen
///           last
/// Warned    where nothing is known of the bed or the ice, and of each iceberg that is known near the place
/// Errors    std::invalid_argument for places off the Earth
[[nodiscard]] SafePlaceFindings check_safe_places(const planning::Plan& plan,
                                                  const vehicle::GliderProfile& vehicle,
                                                  double max_concentration_to_surface,
                                                  const std::vector<SafePlace>& places);

}  // namespace floeplan::mission
