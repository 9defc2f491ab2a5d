#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/grids/axis.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"

namespace floeplan::repository {

/// Neighbouring nodes of a stored axis.
struct NodeRun {
  std::size_t first{};
  std::size_t count{};

  friend bool operator==(const NodeRun&, const NodeRun&) = default;
};

/// Part of a stored axis: runs to be joined in this order, and the joined axis. There are two runs only where
/// the part crosses the seam of a grid that goes round the globe; the longitudes of the second are then a
/// turn higher.
struct AxisWindow {
  std::vector<NodeRun> runs;
  ocean::Axis nodes;
};

struct GridWindow {
  AxisWindow x;
  AxisWindow y;
};

/// The nodes from the last below `low` to the first above `high`. nullopt: the axis ends before or begins
/// after.
[[nodiscard]] std::optional<AxisWindow> window_around(const ocean::Axis& axis, double low, double high);

/// The whole axis.
[[nodiscard]] AxisWindow whole(const ocean::Axis& axis);

/// The nodes around the area, at least one on each side of it where the grid has one. For a projected grid
/// the area is outlined by samples and the window is rather too large than too small.
/// Outside  nullopt when the grid and the area do not meet
[[nodiscard]] std::optional<GridWindow> window_around(const ocean::HorizontalGrid& grid,
                                                      const geo::BoundingBox& area);

/// The window widened to the blocks of `side` nodes a side that it lies in, counted from the grid's first node; along
/// an axis on which it crosses the seam of the globe it stays as it is.
[[nodiscard]] GridWindow in_whole_blocks(const GridWindow& window, const ocean::HorizontalGrid& grid,
                                         std::size_t side);

}  // namespace floeplan::repository
