#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/bed/bathymetry.hpp"

namespace floeplan::ocean {

/// A line of equal depth; a closed line ends where it begins.
using Isobath = std::vector<geo::LonLat>;

/// All lines on which the sea bed has this depth, by marching squares: straight in each cell, between places
/// on its sides. Along a side the depth is linear from node to node. Deeper water lies on the left.
/// Edges    A line ends at the rim of the grid, and at cells with a missing corner. A node of exactly this
///          depth counts as deeper. If two opposite corners are deeper, the mean of all four decides whether
///          the deep parts are joined. No line crosses the seam of a grid that goes round the globe
/// Returns  open lines first, then closed ones, each kind by its lowest, then leftmost side of a cell
/// Source   Lorensen and Cline 1987, Marching cubes, doi:10.1145/37401.37422, in two dimensions
[[nodiscard]] std::vector<Isobath> isobaths(const Bathymetry& bathymetry, core::Metres depth);

}  // namespace floeplan::ocean
