#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/horizontal_grid.hpp"

namespace floeplan::ocean {

/// Depth of the sea bed on a grid; bilinear between nodes.
/// Shape    depth_m is [y][x], metres, positive down; land is zero or negative. NaN marks a missing sample
/// inside the
///          array; it never leaves the class
/// Outside  nullopt beyond the grid and where any of the nodes needed is missing
/// Threads  const members may be called from several threads at once
class Bathymetry {
 public:
  /// Errors  std::invalid_argument when the sizes do not agree
  Bathymetry(HorizontalGrid grid, std::vector<float> depth_m);

  [[nodiscard]] std::optional<core::Metres> depth(geo::LonLat place) const;
  [[nodiscard]] const HorizontalGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<float>& depth_m() const { return depth_m_; }

 private:
  HorizontalGrid grid_;
  std::vector<float> depth_m_;
};

}  // namespace floeplan::ocean
