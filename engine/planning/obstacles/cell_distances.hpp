#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::planning::obstacles {

/// How far it is at least from each cell of a grid to the nearest marked one.
/// Shape    cells are [y][x], last index fastest
/// Threads  const members may be called from several threads at once
class CellDistances {
 public:
  /// Says of every cell that it may be marked itself.
  CellDistances() = default;
  /// `marked`: of each cell, `nx` in a row. `least_cell`: no way across a cell, from side to side, is shorter.
  CellDistances(const std::vector<bool>& marked, std::size_t nx, core::Metres least_cell);

  /// A lower bound of the distance from anywhere in the cell to a marked cell; infinite if none is marked.
  [[nodiscard]] core::Metres from(std::size_t cell) const;

  [[nodiscard]] std::size_t bytes() const { return cells_.size() * sizeof(std::uint32_t); }

 private:
  static constexpr std::uint32_t nowhere = UINT32_MAX;

  std::vector<std::uint32_t> cells_;  // steps to the nearest marked cell, also diagonal ones
  core::Metres least_cell_{};
};

}  // namespace floeplan::planning::obstacles
