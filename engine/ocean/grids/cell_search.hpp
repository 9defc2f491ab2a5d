#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/geo/tangent_plane.hpp"
#include "engine/ocean/grids/cell_weights.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "engine/ocean/grids/node_box.hpp"

namespace floeplan::ocean {

/// A place on the sphere, with the sines and cosines that a change of axes to another place needs.
struct SpherePlace {
  double sin_lon{};
  double cos_lon{};
  double sin_lat{};
  double cos_lat{};

  [[nodiscard]] geo::UnitVector direction() const { return {cos_lat * cos_lon, cos_lat * sin_lon, sin_lat}; }
};

struct Turn {
  double cosine{};
  double sine{};
};

/// The angle, clockwise, by which the bearing of a direction grows when it is carried along the great circle
/// from one place to the other. As geo::convergence, for places whose sines and cosines are known. The two
/// tangent planes differ by this rotation and by a tilt, which changes sum and difference of the axes'
/// products alike.
[[nodiscard]] Turn turn_between(const SpherePlace& from, const SpherePlace& to);

/// Finds the cells of a mesh that contain the nodes of a grid. The mesh is borrowed and must outlive this.
/// Precondition  on both axes of the grid the steps are equal; only the last may be shorter
class CellSearch {
 public:
  CellSearch(const Mesh& mesh, const HorizontalGrid& grid);

  [[nodiscard]] std::size_t nodes() const { return columns_ * rows_; }
  /// The sphere place of a point of the mesh.
  [[nodiscard]] const SpherePlace& point(std::uint32_t number) const { return points_[number]; }

  /// Calls `found(cell, weights, node, place)` for each node that lies in a cell, with the weights of the
  /// corners, if `is_wanted(cell, node)`. Cells come in their order.
  /// Returns  false if many cells overlap, as only damaged positions do; the search then ends early
  template <class IsWanted, class Found>
  [[nodiscard]] bool visit(const IsWanted& is_wanted, const Found& found) const {
    const std::size_t affordable = fair_candidates + candidates_per_node * (nodes() + mesh_.cells.size());
    std::size_t candidates = 0;
    for (const Mesh::Cell& cell : mesh_.cells) {
      const NodeBox box = boxes_.near(cell);
      if (box.count_x == 0 || box.count_y == 0) continue;
      candidates += box.count_x * box.count_y;
      if (candidates > affordable) return false;
      visit_box(cell, box, is_wanted, found);
    }
    return true;
  }

 private:
  static constexpr std::size_t fair_candidates =
      10'000'000;  // nodes tested whatever the size: a fraction of a second
  static constexpr std::size_t candidates_per_node =
      30;  // real meshes need 2 to 6; slender cells oblique to the grid need more

  template <class IsWanted, class Found>
  void visit_box(const Mesh::Cell& cell, const NodeBox& box, const IsWanted& is_wanted,
                 const Found& found) const {
    CellWeights::Corners corners{};
    for (std::size_t i = 0; i < cell.size(); ++i) corners[i] = points_[cell[i]].direction();
    const CellWeights weights{corners, cell[2] == cell[3]};
    for (std::size_t iy = box.first_y; iy < box.first_y + box.count_y; ++iy) {
      for (std::size_t i = 0; i < box.count_x; ++i) {
        const std::size_t ix = (box.first_x + i) % columns_;
        const std::size_t node = iy * columns_ + ix;
        if (!is_wanted(cell, node)) continue;
        const SpherePlace place = node_at(ix, iy);
        if (const auto inside = weights.at(place.direction())) found(cell, *inside, node, place);
      }
    }
  }

  [[nodiscard]] SpherePlace node_at(std::size_t ix, std::size_t iy) const {
    if (!nodes_.empty()) return nodes_[iy * columns_ + ix];
    return {by_column_[ix].sin_lon, by_column_[ix].cos_lon, by_row_[iy].sin_lat, by_row_[iy].cos_lat};
  }

  const Mesh& mesh_;
  NodeBoxes boxes_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<SpherePlace> points_;
  std::vector<SpherePlace> by_column_;  // if the grid is geographic
  std::vector<SpherePlace> by_row_;
  std::vector<SpherePlace> nodes_;  // [y][x], if it is not
};

}  // namespace floeplan::ocean
