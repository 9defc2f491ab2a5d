#pragma once

#include <cstddef>
#include <vector>

#include "engine/planning/obstacles/cell_distances.hpp"
#include "engine/planning/plane/plane_raster.hpp"

namespace floeplan::planning::obstacles {

/// Some marked cells of a raster, and how far each cell is from them. Tells quickly that a line stays clear of all.
/// Threads  const members may be called from several threads at once
class MarkedCells {
 public:
  /// `marked`: of each cell of the raster.
  MarkedCells(const plane::PlaneRaster& raster, const std::vector<bool>& marked);

  /// Whether the straight line from a to b may enter a marked cell, or leave the raster. True also for a line that
  /// passes right beside a marked cell.
  [[nodiscard]] bool may_meet(geo::PlanePoint a, geo::PlanePoint b) const;
  [[nodiscard]] std::size_t bytes() const { return distances_.bytes(); }

 private:
  plane::PlaneRaster raster_;
  CellDistances distances_;
};

}  // namespace floeplan::planning::obstacles
