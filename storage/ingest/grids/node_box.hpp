#pragma once

#include <cstddef>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/grids/source_mesh.hpp"

namespace floeplan::ingest {

/// A rectangle of nodes of a grid. Columns count on past the last one to the first.
struct NodeBox {
  std::size_t first_x{};
  std::size_t count_x{};
  std::size_t first_y{};
  std::size_t count_y{};
};

/// Holds every node of the grid that lies in the cell, and a few others; also for cells across the date line and
/// round a pole.
[[nodiscard]] NodeBox nodes_near(const ocean::HorizontalGrid& grid, const SourceMesh& mesh,
                                 const SourceMesh::Cell& cell);

}  // namespace floeplan::ingest
