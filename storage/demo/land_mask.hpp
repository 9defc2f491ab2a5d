#pragma once

#include <cstdint>
#include <vector>

#include "engine/geo/polygon.hpp"
#include "storage/demo/raster_frame.hpp"

namespace floeplan::demo {

/// 1 where the centre of a cell is land, 0 at sea.
[[nodiscard]] std::vector<std::uint8_t> land_mask(const RasterFrame& frame,
                                                  const std::vector<geo::Polygon>& land);

/// Distance from each cell to the nearest cell with the given value, in cells; zero in cells that have the
/// value.
[[nodiscard]] std::vector<float> cells_to(const RasterFrame& frame, const std::vector<std::uint8_t>& mask,
                                          std::uint8_t value);

/// Share of land around each cell, 0 to 1, in a window of (2 radius + 1) cells squared with soft edges.
[[nodiscard]] std::vector<float> land_share(const RasterFrame& frame, const std::vector<std::uint8_t>& mask,
                                            std::size_t radius);

}  // namespace floeplan::demo
