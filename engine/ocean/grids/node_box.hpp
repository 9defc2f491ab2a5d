#pragma once

#include <cstddef>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"

namespace floeplan::ocean {

/// A rectangle of nodes of a grid. Column numbers past the last one continue at the first.
struct NodeBox {
  std::size_t first_x{};
  std::size_t count_x{};
  std::size_t first_y{};
  std::size_t count_y{};
};

/// Finds which nodes of a grid lie near the cells of a mesh. Both are borrowed and must outlive this.
/// Precondition  as for MeshSampling
class NodeBoxes {
 public:
  NodeBoxes(const HorizontalGrid& grid, const Mesh& mesh);

  /// Holds every node of the grid that lies in the cell, and a few others; also for cells across the date line and
  /// round a pole.
  [[nodiscard]] NodeBox near(const Mesh::Cell& cell) const { return within(cell, 0.0); }
  /// As `near`. For a cell that lies between nodes, or between rows or columns of nodes, also those on both sides.
  [[nodiscard]] NodeBox near_or_beside(const Mesh::Cell& cell) const;

 private:
  /// Position of a point of the mesh among the nodes: 2.5 is half-way from the third to the fourth node.
  struct Position {
    double x{};
    double y{};
  };
  [[nodiscard]] Position position_of(geo::LonLat point) const;
  /// The nodes in the cell, and those at most `steps` grid steps beside it.
  [[nodiscard]] NodeBox within(const Mesh::Cell& cell, double steps) const;

  const HorizontalGrid& grid_;
  const Mesh& mesh_;
  bool is_geographic_;
  double step_x_;  // in the grid's own coordinates
  double step_y_;
  std::vector<Position> positions_;  // of the mesh's points
};

}  // namespace floeplan::ocean
