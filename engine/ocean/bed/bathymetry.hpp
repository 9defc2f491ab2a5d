#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"

namespace floeplan::ocean {

/// Depth of the sea bed on a grid; bilinear between nodes. If a node represents several measurements (a cell
/// of a chart, a resampled grid), the least depth in its cell is stored as well: safety checks use that one.
/// Shape    depth_m and shoalest_m are [y][x], metres, positive down; land is zero or negative. NaN marks a
///          missing sample inside the arrays; no function returns it
/// Outside  nullopt outside the grid and if a needed node is missing
/// Threads  const members may be called from several threads at once
class Bathymetry {
 public:
  /// `shoalest_m`  empty: no cell is known to be shoaler than its node
  /// Errors  std::invalid_argument if the sizes of the arrays differ
  Bathymetry(HorizontalGrid grid, std::vector<float> depth_m, std::vector<float> shoalest_m = {});

  [[nodiscard]] std::optional<core::Metres> depth(geo::LonLat place) const;
  /// The least known depth around the place: of `depth` there and of the cells of the surrounding nodes.
  [[nodiscard]] std::optional<core::Metres> shoalest(geo::LonLat place) const;
  /// `point` is in the coordinates of the grid.
  [[nodiscard]] std::optional<core::Metres> shoalest_at(geo::GridPoint point) const;
  [[nodiscard]] std::optional<core::Metres> shoalest_at(const GridPosition& position) const;
  [[nodiscard]] const HorizontalGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<float>& depth_m() const { return depth_m_; }
  [[nodiscard]] bool knows_shoaler_cells() const { return !shoalest_m_.empty(); }
  /// The least depth in the cell of each node; the node's own depth if no shoaler one is known.
  [[nodiscard]] const std::vector<float>& shoalest_m() const {
    return shoalest_m_.empty() ? depth_m_ : shoalest_m_;
  }
  [[nodiscard]] std::size_t bytes() const { return (depth_m_.size() + shoalest_m_.size()) * sizeof(float); }

 private:
  HorizontalGrid grid_;
  std::vector<float> depth_m_;
  std::vector<float> shoalest_m_;
};

}  // namespace floeplan::ocean
