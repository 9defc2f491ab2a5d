#include "storage/repository/fields/grid_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::repository {
namespace {

constexpr double rounding = 1e-6;  // of a step, as Axis::locate has it

/// Nodes `first` to `last`, both included.
AxisWindow part(const ocean::Axis& axis, std::size_t first, std::size_t last) {
  const auto begin = axis.nodes().begin();
  return {{{first, last - first + 1}},
          ocean::Axis{
              {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last) + 1}}};
}

/// Number of nodes within one turn from the first: all, unless the seam is stored twice (0 and 360).
std::size_t distinct_longitudes(const ocean::Axis& x) {
  const auto end = std::ranges::lower_bound(x.nodes(), x.front() + 360.0 - 1e-6);
  return static_cast<std::size_t>(end - x.nodes().begin());
}

/// Window of an axis around the globe. Its nodes are numbered eastwards, continuing after each turn.
AxisWindow window_round_the_globe(const ocean::Axis& x, double west_deg, double width_deg) {
  const auto turn = static_cast<std::ptrdiff_t>(distinct_longitudes(x));
  const auto begin = x.nodes().begin();
  const double west = west_deg - 360.0 * std::floor((west_deg - x.front()) / 360.0);
  const double turns_to_east = std::floor((west + width_deg - x.front()) / 360.0);
  const double east = west + width_deg - 360.0 * turns_to_east;

  std::ptrdiff_t first = std::lower_bound(begin, begin + turn, west) - begin - 1;
  std::ptrdiff_t last =
      std::upper_bound(begin, begin + turn, east) - begin + turn * static_cast<std::ptrdiff_t>(turns_to_east);
  if (last - first + 1 >= turn) return whole(x);
  if (first < 0) {
    first += turn;
    last += turn;
  }

  std::vector<double> nodes;
  for (std::ptrdiff_t i = first; i <= last; ++i) {
    const std::ptrdiff_t turns = i / turn;
    nodes.push_back(begin[i % turn] + 360.0 * static_cast<double>(turns));
  }
  // A number beyond one turn means the same node again, 360 degrees further east.
  const auto run = [](std::ptrdiff_t from, std::ptrdiff_t to) {
    return NodeRun{static_cast<std::size_t>(from), static_cast<std::size_t>(to - from)};
  };
  if (last < turn) return {{run(first, last + 1)}, ocean::Axis{std::move(nodes)}};
  return {{run(first, turn), run(0, last + 1 - turn)}, ocean::Axis{std::move(nodes)}};
}

/// Window of an axis that does not go around the globe. An area that reaches both ends across the gap gets
/// the whole axis.
std::optional<AxisWindow> window_of_longitudes(const ocean::Axis& x, double west_deg, double width_deg) {
  const double west =
      west_deg - 360.0 * (std::floor((west_deg - x.front()) / 360.0) + 1.0);  // a turn before the axis
  const double slack = rounding * x.mean_step();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (int turn = 0; turn <= 2; ++turn) {
    double from = west + 360.0 * turn;
    // A place at the first or the last node may be beside it by the rounding of the turns.
    if (std::abs(from + width_deg - x.front()) <= slack) from = x.front() - width_deg;
    if (std::abs(from - x.back()) <= slack) from = x.back();
    if (from + width_deg < x.front() || from > x.back()) continue;
    low = std::min(low, from);
    high = std::max(high, from + width_deg);
  }
  return window_around(x, low, high);
}

struct Extent {
  double low{std::numeric_limits<double>::infinity()};
  double high{-std::numeric_limits<double>::infinity()};

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// The window of an area in grid coordinates, found from a lattice of samples. It is widened by a part of
/// their spacing, because the area's edge is curved between them. Where the projection has no value, the
/// window has no limit.
std::optional<GridWindow> window_of_projected(const ocean::HorizontalGrid& grid,
                                              const geo::BoundingBox& area) {
  constexpr int steps = 48;
  // As a share of the spacing of two samples: an arc of up to a right angle rises above its chord by at most
  // a fifth of the chord.
  constexpr double bulge = 0.25;
  const double width = geo::width_deg(area);
  Extent x;
  Extent y;
  double widest = 0.0;
  std::vector<geo::GridPoint> row_before;
  for (int j = 0; j <= steps; ++j) {
    const double lat = area.south_deg + (area.north_deg - area.south_deg) * j / steps;
    std::vector<geo::GridPoint> row;
    for (int i = 0; i <= steps; ++i) {
      const geo::GridPoint point = grid.projection().to_grid({area.west_deg + width * i / steps, lat});
      if (!std::isfinite(point.x) || !std::isfinite(point.y))
        return GridWindow{whole(grid.x()), whole(grid.y())};
      x.include(point.x);
      y.include(point.y);
      if (i > 0) widest = std::max(widest, std::hypot(point.x - row.back().x, point.y - row.back().y));
      row.push_back(point);
      if (j > 0) {
        const geo::GridPoint below = row_before[static_cast<std::size_t>(i)];
        widest = std::max(widest, std::hypot(point.x - below.x, point.y - below.y));
      }
    }
    row_before = std::move(row);
  }
  const auto around = [&](const ocean::Axis& axis, const Extent& extent) {
    // A place at a node of the rim may be beside it by the rounding of the projection.
    const double margin = bulge * widest + rounding * axis.mean_step();
    return window_around(axis, extent.low - margin, extent.high + margin);
  };
  auto x_window = around(grid.x(), x);
  auto y_window = around(grid.y(), y);
  if (!x_window || !y_window) return std::nullopt;
  return GridWindow{std::move(*x_window), std::move(*y_window)};
}

}  // namespace

AxisWindow whole(const ocean::Axis& axis) { return {{{0, axis.size()}}, axis}; }

std::optional<AxisWindow> window_around(const ocean::Axis& axis, double low, double high) {
  if (!(high >= axis.front() && low <= axis.back())) return std::nullopt;
  const auto begin = axis.nodes().begin();
  const auto not_below = static_cast<std::size_t>(std::ranges::lower_bound(axis.nodes(), low) - begin);
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(axis.nodes(), high) - begin);
  return part(axis, not_below == 0 ? 0 : not_below - 1, std::min(above, axis.size() - 1));
}

std::optional<GridWindow> window_around(const ocean::HorizontalGrid& grid, const geo::BoundingBox& area) {
  if (!std::holds_alternative<geo::GeographicFrame>(grid.frame())) return window_of_projected(grid, area);

  auto y = window_around(grid.y(), area.south_deg, area.north_deg);
  if (!y) return std::nullopt;
  const bool closed = grid.wraps() || grid.x().back() - grid.x().front() >= 360.0 - 1e-6;
  auto x = closed ? window_round_the_globe(grid.x(), area.west_deg, geo::width_deg(area))
                  : window_of_longitudes(grid.x(), area.west_deg, geo::width_deg(area));
  if (!x) return std::nullopt;
  return GridWindow{std::move(*x), std::move(*y)};
}

GridWindow in_whole_blocks(const GridWindow& window, const ocean::HorizontalGrid& grid, std::size_t side) {
  const auto widened = [side](const AxisWindow& along, const ocean::Axis& axis) {
    if (along.runs.size() > 1) return along;
    const NodeRun run = along.runs.front();
    const std::size_t first = run.first / side * side;
    const std::size_t end = (run.first + run.count + side - 1) / side * side;
    return part(axis, first, std::min(end, axis.size()) - 1);
  };
  return {widened(window.x, grid.x()), widened(window.y, grid.y())};
}

}  // namespace floeplan::repository
