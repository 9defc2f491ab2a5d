#include "engine/mission/document/thruster_yo.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::mission {

std::optional<core::Watts> thruster_of_yo(const planning::Plan& plan, const vehicle::GliderProfile& vehicle) {
  constexpr double same_speed_m_s = 1e-3;  // smaller than a thruster can control
  if (!vehicle.thruster || plan.waypoints.size() < 2) return std::nullopt;
  const bool as_planned =
      std::all_of(plan.waypoints.begin() + 1, plan.waypoints.end(), [&](const planning::Waypoint& waypoint) {
        return waypoint.drive == vehicle::Drive::thruster && waypoint.speed_through_water &&
               std::abs((*waypoint.speed_through_water - vehicle.thruster->speed).value) <= same_speed_m_s;
      });
  const core::Watts power = vehicle.thruster->power;
  if (!as_planned || power < least_thruster_power || power > most_thruster_power) return std::nullopt;
  return power;
}

}  // namespace floeplan::mission
