#pragma once

#include <cstdint>

namespace floeplan::planning::obstacles {

/// Whether a vehicle may be in a cell of the safety map, and if not, why.
enum class CellState : std::uint8_t { open, too_shallow, on_land, outside_data, in_zone };

}  // namespace floeplan::planning::obstacles
