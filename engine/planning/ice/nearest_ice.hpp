#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/ice/under_ice.hpp"

namespace floeplan::planning::ice {

/// The deepest turn that the ice asks dives for at a place or within a distance of it, as far as looks at rings round
/// it tell. Zero where there is none, and where nothing is known of the ice.
[[nodiscard]] core::Metres deepest_turn_within(core::Metres distance, const UnderIce& ice,
                                               geo::PlanePoint place, core::Seconds when);

/// How far it is to the nearest ice that asks dives to turn below it, to any side, as far as looks at rings round the
/// place tell; empty where there is none within the distance, and where nothing is known of the ice. Both in metres of
/// the plane.
[[nodiscard]] std::optional<core::Metres> nearest_ice_within(core::Metres distance, const UnderIce& ice,
                                                             geo::PlanePoint place, core::Seconds when);

}  // namespace floeplan::planning::ice
