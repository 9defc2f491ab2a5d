#include "engine/planning/obstacles/cell_distances.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::obstacles {

CellDistances::CellDistances(const std::vector<bool>& marked, std::size_t nx, core::Metres least_cell)
    : cells_(marked.size(), nowhere), least_cell_{least_cell} {
  if (nx == 0) return;
  const auto columns = static_cast<std::ptrdiff_t>(nx);
  const auto rows = static_cast<std::ptrdiff_t>(marked.size() / nx);
  const auto step_from = [&](std::ptrdiff_t ix, std::ptrdiff_t iy) {
    if (ix < 0 || ix >= columns || iy < 0 || iy >= rows) return nowhere;
    const std::uint32_t there = cells_[static_cast<std::size_t>(iy * columns + ix)];
    return there == nowhere ? nowhere : there + 1;
  };
  const auto relax = [&](std::ptrdiff_t ix, std::ptrdiff_t iy, std::ptrdiff_t back) {
    std::uint32_t& here = cells_[static_cast<std::size_t>(iy * columns + ix)];
    here = std::min({here, step_from(ix - back, iy), step_from(ix - back, iy - back),
                     step_from(ix, iy - back), step_from(ix + back, iy - back)});
  };
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (marked[i]) cells_[i] = 0;
  }
  for (std::ptrdiff_t iy = 0; iy < rows; ++iy) {
    for (std::ptrdiff_t ix = 0; ix < columns; ++ix) relax(ix, iy, 1);
  }
  for (std::ptrdiff_t iy = rows; iy-- > 0;) {
    for (std::ptrdiff_t ix = columns; ix-- > 0;) relax(ix, iy, -1);
  }
}

core::Metres CellDistances::from(std::size_t cell) const {
  if (cells_.empty()) return core::Metres{0.0};
  if (cells_[cell] == nowhere) return core::Metres{INFINITY};
  // The first and the last cell may be crossed only in part.
  return core::Metres{std::max(0.0, static_cast<double>(cells_[cell]) - 1.0) * least_cell_.value};
}

}  // namespace floeplan::planning::obstacles
