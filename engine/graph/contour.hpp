#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/graph/grid_graph.hpp"

namespace floeplan::graph {

/// A place on a grid in columns and rows; vertices have whole numbers.
struct GridPlace {
  double column{};
  double row{};
};

/// A closed line; the last place joins the first and is not repeated.
using GridRing = std::vector<GridPlace>;

/// An area of a grid. The outer line runs counter-clockwise (columns to the right, rows upwards), holes
/// clockwise. Rings neither touch nor cross each other or themselves.
struct GridPolygon {
  GridRing outer;
  std::vector<GridRing> holes;
};

/// Where the border crosses the line from a vertex inside to its neighbour outside, as a share of that line.
using BorderShare = std::function<double(Vertex inside, Vertex outside)>;

/// The area around the vertices that are inside, by marching squares. Beyond the grid nothing is inside, so
/// the area ends on its rim. Where two inside vertices face each other across a cell, the cell parts them: an area
/// with more inside and borders no further in covers the former one.
/// `inside` has one entry for each vertex; `share` is asked for each line that the border crosses.
/// Returns  the polygons by their lowest, then leftmost border
/// Source   Lorensen and Cline 1987, Marching cubes, doi:10.1145/37401.37422, in two dimensions
[[nodiscard]] std::vector<GridPolygon> contour(int nx, int ny, const std::vector<std::uint8_t>& inside,
                                               const BorderShare& share);

}  // namespace floeplan::graph
