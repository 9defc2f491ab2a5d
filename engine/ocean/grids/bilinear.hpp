#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "engine/ocean/grids/horizontal_grid.hpp"

namespace floeplan::ocean {

/// Bilinear interpolation in one horizontal slice [y][x] with `nx` nodes per row; NaN marks missing nodes.
/// Outside  nullopt if a node with a weight above zero is missing
[[nodiscard]] inline std::optional<double> bilinear(std::span<const float> slice, std::size_t nx,
                                                    const GridPosition& at) {
  const auto node = [&](std::size_t ix, std::size_t iy) { return static_cast<double>(slice[iy * nx + ix]); };
  const auto row = [&](std::size_t iy) {
    const double left = node(at.x.lower, iy);
    return at.x.fraction == 0.0 ? left : left + at.x.fraction * (node(at.x.upper, iy) - left);
  };
  const double south = row(at.y.lower);
  const double value = at.y.fraction == 0.0 ? south : south + at.y.fraction * (row(at.y.upper) - south);
  if (value != value) return std::nullopt;  // only NaN differs from itself
  return value;
}

}  // namespace floeplan::ocean
