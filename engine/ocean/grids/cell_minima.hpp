#pragma once

#include <span>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"

namespace floeplan::ocean {

/// At the nodes of a grid the least of what is known at the corners of the cells near them: at any place in a cell and in the
/// grid at least one of the nodes round it has no more than the least known corner of that cell. Cells are as wide here
/// as the rectangle of nodes round them.
/// Shape    values are [point], NaN where missing; output [y][x], NaN where no cell with a known corner is near
/// Precondition  as of MeshSampling
[[nodiscard]] std::vector<float> least_of_cells(const Mesh& mesh, const HorizontalGrid& grid,
                                                std::span<const float> values);

}  // namespace floeplan::ocean
