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

/// A place on the sphere, and what turns its east and north into those of another.
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

/// By which a direction's bearing grows, clockwise, when it is carried along the great circle; as geo::convergence, of
/// places whose sines and cosines are known. The two pairs of axes differ by that turn and by the tilt from one tangent
/// plane to the other, which acts on sum and difference of their products alike.
[[nodiscard]] Turn turn_between(const SpherePlace& from, const SpherePlace& to);

/// Finds the cells of a mesh in which the nodes of a grid lie. The mesh is borrowed and outlives this.
/// Precondition  the steps of either axis of the grid are equal, but for a last one that is shorter
class CellSearch {
 public:
  CellSearch(const Mesh& mesh, const HorizontalGrid& grid);

  [[nodiscard]] std::size_t nodes() const { return columns_ * rows_; }
  /// Of a point of the mesh.
  [[nodiscard]] const SpherePlace& point(std::uint32_t number) const { return points_[number]; }

  /// Calls `found(cell, weights, node, place)` with the weights of the corners for each node in a cell, if
  /// `is_wanted(cell, node)`. Cells come in their order.
  /// Returns  false where cells lie over one another many times over, as only damaged positions do; it ends early then
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
      10'000'000;  // nodes looked at whatever the size: a fraction of a second
  static constexpr std::size_t candidates_per_node =
      30;  // real meshes need 2 to 6, slender cells athwart the grid more

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
  std::vector<SpherePlace> by_column_;  // of a geographic grid
  std::vector<SpherePlace> by_row_;
  std::vector<SpherePlace> nodes_;  // [y][x] of any other
};

}  // namespace floeplan::ocean
