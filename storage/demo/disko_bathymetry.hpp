#pragma once

#include <cstdint>
#include <vector>

#include "engine/geo/polygon.hpp"
#include "storage/demo/raster_frame.hpp"

namespace floeplan::demo {

inline constexpr double disko_cell_m = 278.0;

/// Height of the ground and of the sea bed in every cell, metres, positive up; and which cells are land.
struct Relief {
  RasterFrame frame;
  std::vector<float> elevation_m;  // at sea at most -2, on land at least 2
  std::vector<std::uint8_t> land;
};

/// Invented relief of Disko Bay around the true coast: a shelf along the coast and between islands, a trough
/// of 400 to 500 m across the bay with the Egedesminde deep, a sill of 200 to 250 m before the icefjord and
/// 700 to 800 m inside.
[[nodiscard]] Relief make_disko_relief(const std::vector<geo::Polygon>& land, std::uint64_t seed);

/// Depth of the sea, metres, positive down, in each cell of `frame`: the mean over those sea cells of the
/// relief whose centres lie in the cell; zero where there are none.
[[nodiscard]] std::vector<double> mean_depth_m(const Relief& relief, const RasterFrame& frame);

/// Depth at a place, metres, positive down, taken from the relief's nearest cell; negative on land.
[[nodiscard]] double depth_m(const Relief& relief, geo::LonLat place);

}  // namespace floeplan::demo
