#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/bed/bathymetry.hpp"

namespace floeplan::ocean {

/// A line of one depth; a closed one ends where it begins.
using Isobath = std::vector<geo::LonLat>;

/// Every line on which the sea bed is `depth` deep, by marching squares: straight in each cell, between the places on
/// its sides where the depth, linear from node to node, is that. Deeper water is on the left.
/// Edges    a line ends at the rim of the grid, and at cells of which a corner is missing; a node that is exactly so
///          deep counts as deeper; where two opposite corners are deeper, the mean of all four says whether the deep
///          parts are joined; no line runs across the seam of a grid that goes round the globe
/// Returns  open lines first, then closed ones, each by its lowest, then leftmost side of a cell
/// Source   Lorensen and Cline 1987, Marching cubes, doi:10.1145/37401.37422, in two dimensions
[[nodiscard]] std::vector<Isobath> isobaths(const Bathymetry& bathymetry, core::Metres depth);

}  // namespace floeplan::ocean
