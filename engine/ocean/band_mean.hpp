#pragma once

#include <cstddef>
#include <optional>

#include "engine/ocean/current_grid.hpp"

namespace floeplan::ocean {

/// Mean over a band of depths at a node of the grid: what the node's column gives, without making one of all its
/// levels. Empty where the column is.
[[nodiscard]] std::optional<geo::VelocityEn> band_mean_at_node(const CurrentGrid& currents, std::size_t ix,
                                                               std::size_t iy, std::size_t time_index,
                                                               core::Metres top, core::Metres bottom);

}  // namespace floeplan::ocean
