#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/zone.hpp"
#include "engine/planning/obstacles/safety_map.hpp"

namespace floeplan::planning::obstacles {

/// The depths that a vehicle moves between, positive down.
struct DepthBand {
  core::Metres shallowest;
  core::Metres deepest;
};

/// Zones sorted by how they are obeyed. Only those that concern the vehicle's depths remain; a stay-in zone
/// without room for them holds no place for this vehicle.
struct ZoneRules {
  StandingZones standing;          // always in force: part of the safety map
  std::vector<ocean::Zone> timed;  // in force for a while: tested along the drive
};

/// A stay-in zone that is in force for a while takes the standing ones with it: at any time the vehicle must be in
/// one of those in force.
[[nodiscard]] ZoneRules sort_zones(const std::vector<ocean::Zone>& zones, DepthBand band);

}  // namespace floeplan::planning::obstacles
