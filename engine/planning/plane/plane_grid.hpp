#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/planning/plane/fast_axis.hpp"
#include "engine/planning/plane/grid_lookup.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// The nodes of a data grid around an area of the plane, with a fast search for the cell of a point.
/// Shape    arrays over it are [y][x], last index fastest
/// Threads  const members may be called from several threads at once
class PlaneGrid {
 public:
  /// The cell of a point: index of its first node, and the position in the cell as shares of its width and
  /// height.
  struct Corner {
    std::size_t first;
    double fx;
    double fy;
  };

  /// Once `stop` is requested the grid stays incomplete and must not be used.
  PlaneGrid(const ocean::HorizontalGrid& grid, const geo::LocalProjection& projection, const PlaneBox& area,
            const std::stop_token& stop);

  [[nodiscard]] std::size_t nx() const { return x_.size(); }
  [[nodiscard]] std::size_t ny() const { return y_.size(); }
  [[nodiscard]] std::size_t size() const { return x_.size() * y_.size(); }
  /// Column and row of the data grid, for a column and row of this grid.
  [[nodiscard]] std::size_t column(std::size_t ix) const { return columns_[ix]; }
  [[nodiscard]] std::size_t row(std::size_t iy) const { return first_row_ + iy; }
  /// The cell of a point; empty outside the data's nodes, and if they have only one column or row.
  [[nodiscard]] std::optional<Corner> corner(geo::PlanePoint point) const;
  /// Column and row of a point among the nodes around the area; whole numbers on the nodes; empty as
  /// `corner`.
  [[nodiscard]] std::optional<geo::GridPoint> place_among_nodes(geo::PlanePoint point) const;
  /// Shortest distance between opposite sides of a cell, in metres of the plane. Zero if the data's
  /// longitudes jump, because the distance is then unknown.
  [[nodiscard]] double least_cell_m() const;

 private:
  GridLookup lookup_;
  FastAxis x_;  // longitudes continuous, also across the data's seam
  FastAxis y_;
  std::vector<std::size_t> columns_;  // column in the data, for each node of x_
  std::size_t first_row_{};
};

}  // namespace floeplan::planning::plane
