#pragma once

#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::mission {

/// A place to recover to, and what is known of the sea there; of its parts only bathymetry, land and ice are looked at.
struct SafePlace {
  geo::LonLat place;
  ocean::Environment sea;
};

struct SafePlaceFindings {
  core::Violations violations;        // "/safe/0" and so on
  std::vector<std::string> warnings;  // what the data do not tell
};

/// Judges the places that a vehicle shall recover to from under ice.
/// Refused   land and water too shallow for the vehicle; ice denser than `max_concentration_to_surface` at some time of the
///           plan, the first and last step of the ice holding for ocean::longest_ice_hold; what the rest of the battery
///           does not reach in still water from any waypoint, at the plan's mean power
/// Warned    where nothing is known of the bed or the ice
/// Errors    std::invalid_argument for places off the Earth
[[nodiscard]] SafePlaceFindings check_safe_places(const planning::Plan& plan,
                                                  const vehicle::GliderProfile& vehicle,
                                                  double max_concentration_to_surface,
                                                  const std::vector<SafePlace>& places);

}  // namespace floeplan::mission
