#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/zone.hpp"
#include "engine/planning/obstacles/safety_map.hpp"

namespace floeplan::planning::obstacles {

/// The range of depths of a vehicle, positive down.
struct DepthBand {
  core::Metres shallowest;
  core::Metres deepest;
};

/// Zones sorted by the way they are tested. Zones that do not concern the vehicle's depths are left out. A
/// stay-in zone that does not include the vehicle's whole band of depths allows the vehicle no place.
struct ZoneRules {
  StandingZones standing;          // always in force; tested in the safety map
  std::vector<ocean::Zone> timed;  // in force for a while; tested along the drive
};

/// Sorts zones into standing and timed ones. If any stay-in zone is timed, all stay-in zones count as timed: at
/// each time the vehicle must be in at least one of those that are in force.
[[nodiscard]] ZoneRules sort_zones(const std::vector<ocean::Zone>& zones, DepthBand band);

}  // namespace floeplan::planning::obstacles
