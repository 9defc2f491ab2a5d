#pragma once

#include <optional>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/currents/current_grid.hpp"

namespace floeplan::ocean {

/// Whether a plan knows the current at the place: each corner of its cell has water or is next to a node with
/// water, whose current it takes (see planning::currents::PlaneCurrents, Coast). A node has water if the grid
/// has a current at its uppermost level at the first or the last time.
[[nodiscard]] bool has_water_around(const CurrentGrid& currents, geo::LonLat place);

/// The node with water that lies nearest to the place; nullopt if no node has water. Looks at every node, so
/// it is for refusals, not for searches.
[[nodiscard]] std::optional<geo::LonLat> nearest_water(const CurrentGrid& currents, geo::LonLat place);

}  // namespace floeplan::ocean
