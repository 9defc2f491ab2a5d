#pragma once

#include <span>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"

namespace floeplan::ocean {

/// For each node of a grid, the least known value at the corners of the cells near it. For any place inside a cell
/// and the grid, at least one node round the place thus has a value no greater than the least known corner of the
/// cell. A cell counts as the whole rectangle of nodes round it.
/// Shape    values are [point], NaN where missing; output [y][x], NaN where no cell with a known corner is near
/// Precondition  as of MeshSampling
[[nodiscard]] std::vector<float> least_of_cells(const Mesh& mesh, const HorizontalGrid& grid,
                                                std::span<const float> values);

}  // namespace floeplan::ocean
