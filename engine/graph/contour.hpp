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

/// A closed line. The last place is joined to the first, which is not repeated.
using GridRing = std::vector<GridPlace>;

/// An area of a grid. The outer ring runs counter-clockwise (columns to the right, rows upwards), holes
/// clockwise. Rings neither touch nor cross.
struct GridPolygon {
  GridRing outer;
  std::vector<GridRing> holes;
};

/// Where the outline crosses the line from an inside vertex to an outside neighbour, as a share of that line.
using BorderShare = std::function<double(Vertex inside, Vertex outside)>;

/// The area around the inside vertices, by marching squares. Everything outside the grid is outside, so the
/// area ends on the grid's rim. If only two opposite corners of a cell are inside, they are not connected. So
/// the area grows monotonically: more inside vertices, or outlines further out, give an area that contains
/// the former one.
/// `inside` has one entry per vertex; `share` is called for each line that the outline crosses.
/// Returns  the polygons, ordered by their lowest, then leftmost outline
/// Source   Lorensen and Cline 1987, Marching cubes, doi:10.1145/37401.37422, in two dimensions
[[nodiscard]] std::vector<GridPolygon> contour(int nx, int ny, const std::vector<std::uint8_t>& inside,
                                               const BorderShare& share);

}  // namespace floeplan::graph
