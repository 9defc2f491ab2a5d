#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/grids/axis.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"

namespace floeplan::repository {

/// Consecutive nodes of a stored axis.
struct NodeRun {
  std::size_t first{};
  std::size_t count{};

  friend bool operator==(const NodeRun&, const NodeRun&) = default;
};

/// Part of a stored axis: runs of nodes to be joined in this order, and the joined axis. There are two runs
/// only if the part crosses the seam of a grid around the globe; the longitudes of the second run are then
/// 360 degrees higher.
struct AxisWindow {
  std::vector<NodeRun> runs;
  ocean::Axis nodes;
};

struct GridWindow {
  AxisWindow x;
  AxisWindow y;
};

/// The nodes from the last below `low` to the first above `high`. nullopt: the axis ends before `low` or
/// begins after `high`.
[[nodiscard]] std::optional<AxisWindow> window_around(const ocean::Axis& axis, double low, double high);

/// The whole axis.
[[nodiscard]] AxisWindow whole(const ocean::Axis& axis);

/// The nodes around the area, at least one on each side if the grid has one. For a projected grid the area is
/// approximated by samples, and the window may be too large but not too small.
/// Outside  nullopt when the grid and the area do not intersect
[[nodiscard]] std::optional<GridWindow> window_around(const ocean::HorizontalGrid& grid,
                                                      const geo::BoundingBox& area);

/// The window extended to whole blocks of `side` nodes along each axis, counted from the grid's first node.
/// Along an axis on which the window crosses the seam of the globe it stays unchanged.
[[nodiscard]] GridWindow in_whole_blocks(const GridWindow& window, const ocean::HorizontalGrid& grid,
                                         std::size_t side);

}  // namespace floeplan::repository
