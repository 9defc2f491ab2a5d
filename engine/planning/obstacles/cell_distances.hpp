#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::planning::obstacles {

/// Lower bounds of the distance from each cell of a grid to the nearest marked cell.
/// Shape    cells are [y][x], last index fastest
/// Threads  const members may be called from several threads at once
class CellDistances {
 public:
  /// Without a grid: every distance is zero.
  CellDistances() = default;
  /// `marked`: one value for each cell, `nx` cells in a row. `least_cell`: shortest distance between opposite
  /// sides of a cell.
  CellDistances(const std::vector<bool>& marked, std::size_t nx, core::Metres least_cell);

  /// A lower bound of the distance from anywhere in the cell to a marked cell; infinite if none is marked.
  [[nodiscard]] core::Metres from(std::size_t cell) const;

  [[nodiscard]] std::size_t bytes() const { return cells_.size() * sizeof(std::uint32_t); }

 private:
  static constexpr std::uint32_t nowhere = UINT32_MAX;

  std::vector<std::uint32_t> cells_;  // number of steps to the nearest marked cell, diagonal ones included
  core::Metres least_cell_{};
};

}  // namespace floeplan::planning::obstacles
