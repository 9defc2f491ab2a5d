#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::planning {

class UnderIce;

/// The deepest ice near a way: where a vehicle whose position is not known for certain may come to be.
struct IceBeside {
  core::Metres upper_turn{};  // that the ice asks dives for; 0: there is none
  core::Metres error{};       // of the position there
  geo::LonLat place{};        // on the way
};

/// The deepest turn that the ice asks dives for at a place or within a distance of it, as far as looks at rings round
/// it tell. Zero where there is none, and where nothing is known of the ice.
[[nodiscard]] core::Metres deepest_turn_within(core::Metres distance, const UnderIce& ice,
                                               geo::PlanePoint place, core::Seconds when);

/// How far it is to the nearest ice that asks dives to turn below it, to any side, as far as looks at rings round the
/// place tell; empty where there is none within the distance, and where nothing is known of the ice. Both in metres of
/// the plane.
[[nodiscard]] std::optional<core::Metres> nearest_ice_within(core::Metres distance, const UnderIce& ice,
                                                             geo::PlanePoint place, core::Seconds when);

}  // namespace floeplan::planning
