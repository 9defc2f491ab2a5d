#include "engine/planning/plane/node_window.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace floeplan::planning::plane {
namespace {

struct Window {
  std::vector<double> nodes;
  std::vector<std::size_t> indices;
};

/// The nodes of an axis from the last one below `low` to the first one above `high`.
Window window(const ocean::Axis& axis, double low, double high) {
  const auto& nodes = axis.nodes();
  auto first = static_cast<std::size_t>(std::ranges::lower_bound(nodes, low) - nodes.begin());
  auto last = static_cast<std::size_t>(std::ranges::upper_bound(nodes, high) - nodes.begin());
  first = std::min(first > 0 ? first - 1 : 0, nodes.size() - 1);
  last = std::max(std::min(last, nodes.size() - 1), first);
  Window result;
  for (std::size_t i = first; i <= last; ++i) {
    result.nodes.push_back(nodes[i]);
    result.indices.push_back(i);
  }
  return result;
}

/// As `window` for longitudes: whole turns are added so that the nodes run from west to east without a jump.
Window longitude_window(const ocean::HorizontalGrid& grid, double west, double east) {
  const ocean::Axis& axis = grid.x();
  Window result;
  for (int turn = -2; turn <= 2; ++turn) {
    for (std::size_t i = 0; i < axis.size(); ++i) {
      const double lon = axis[i] + 360.0 * turn;
      const double step = std::max(axis.mean_step(), 1e-6);
      if (lon < west - 1.5 * step || lon > east + 1.5 * step) continue;
      // If the grid repeats its first column after a full turn, the repeated column is skipped.
      if (!result.nodes.empty() && lon <= result.nodes.back() + 1e-6 * step) continue;
      // The last and the first column are neighbours only if the grid covers the full circle.
      if (!result.nodes.empty() && !grid.wraps() && lon - result.nodes.back() > 1.5 * step &&
          result.indices.back() + 1 != i) {
        return result;
      }
      result.nodes.push_back(lon);
      result.indices.push_back(i);
    }
  }
  return result;
}

struct CoordinateBox {
  double low_x{std::numeric_limits<double>::infinity()};
  double high_x{-std::numeric_limits<double>::infinity()};
  double low_y{std::numeric_limits<double>::infinity()};
  double high_y{-std::numeric_limits<double>::infinity()};
};

CoordinateBox coordinate_box(const GridLookup& lookup, const PlaneBox& area) {
  constexpr int samples = 64;
  CoordinateBox box;
  for (int j = 0; j <= samples; ++j) {
    for (int i = 0; i <= samples; ++i) {
      const geo::GridPoint at = lookup.coordinates(
          {area.low.x_m + area.width_m() * i / samples, area.low.y_m + area.height_m() * j / samples});
      box.low_x = std::min(box.low_x, at.x);
      box.high_x = std::max(box.high_x, at.x);
      box.low_y = std::min(box.low_y, at.y);
      box.high_y = std::max(box.high_y, at.y);
    }
  }
  return box;
}

Window column_window(const ocean::HorizontalGrid& grid, const CoordinateBox& box) {
  Window result = std::holds_alternative<geo::GeographicFrame>(grid.frame())
                      ? longitude_window(grid, box.low_x, box.high_x)
                      : window(grid.x(), box.low_x, box.high_x);
  if (result.nodes.empty()) result = {{grid.x().front()}, {0}};  // grid misses the area: finds no point
  return result;
}

}  // namespace

NodeWindow node_window(const ocean::HorizontalGrid& grid, const GridLookup& lookup, const PlaneBox& area) {
  const CoordinateBox box = coordinate_box(lookup, area);
  Window columns = column_window(grid, box);
  Window rows = window(grid.y(), box.low_y, box.high_y);
  return {.x = std::move(columns.nodes),
          .y = std::move(rows.nodes),
          .columns = std::move(columns.indices),
          .first_row = rows.indices.front()};
}

}  // namespace floeplan::planning::plane
