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

/// A recovery place, and the environment there; bathymetry, land, ice, icebergs and zones are used.
struct SafePlace {
  geo::LonLat place;
  ocean::Environment sea;
};

struct SafePlaceFindings {
  core::Violations violations;              // "/safe/0" and so on
  std::vector<messages::Message> messages;  // missing data
};

/// Checks the places to which a vehicle shall recover from under ice.
/// Refused   land and water too shallow for the vehicle; ice denser than `max_concentration_to_surface` at
///           some time of the plan, where first and last step of the ice are held for
///           ocean::longest_ice_hold; places that the remaining battery reaches from no waypoint, in still
///           water at the plan's mean power; a no-go area of any depths that is in force during the plan or
///           after it; places that an iceberg covered when it was last seen
/// Warned    if the bed or the ice is unknown, and of each known iceberg near the place
/// Errors    std::invalid_argument for invalid places
[[nodiscard]] SafePlaceFindings check_safe_places(const planning::Plan& plan,
                                                  const vehicle::GliderProfile& vehicle,
                                                  double max_concentration_to_surface,
                                                  const std::vector<SafePlace>& places);

}  // namespace floeplan::mission
