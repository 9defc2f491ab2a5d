#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/ice/under_ice.hpp"

namespace floeplan::planning::ice {

/// The deepest upper turn that dives need below the ice within a distance of a place. The ice is sampled on
/// rings round the place. Zero if there is no such ice, or the ice is unknown.
[[nodiscard]] core::Metres deepest_turn_within(core::Metres distance, const UnderIce& ice,
                                               geo::PlanePoint place, core::Seconds when);

/// The distance from a place to the nearest ice that dives must turn below, in any direction. The ice is
/// sampled on rings round the place. Empty if there is no such ice within `distance`, or the ice is unknown.
/// Distances are in metres of the plane.
[[nodiscard]] std::optional<core::Metres> nearest_ice_within(core::Metres distance, const UnderIce& ice,
                                                             geo::PlanePoint place, core::Seconds when);

}  // namespace floeplan::planning::ice
