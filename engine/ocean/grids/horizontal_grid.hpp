#pragma once

#include <cstddef>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/grid_frame.hpp"
#include "engine/ocean/grids/axis.hpp"

namespace floeplan::ocean {

/// The position of a place in a grid, for bilinear interpolation.
struct GridPosition {
  AxisPosition x;
  AxisPosition y;
};

/// A grid of nodes x[i], y[j] in a frame. Arrays over it have the shape [y][x], last index fastest, y
/// ascending.
/// Edges    a geographic grid all round the globe also interpolates across its seam
/// Threads  const members may be called from several threads at once
class HorizontalGrid {
 public:
  HorizontalGrid(const geo::GridFrame& frame, Axis x, Axis y);

  [[nodiscard]] const geo::GridFrame& frame() const { return projection_.frame(); }
  /// Between places and points in the grid's own coordinates.
  [[nodiscard]] const geo::FrameProjection& projection() const { return projection_; }
  [[nodiscard]] const Axis& x() const { return x_; }
  [[nodiscard]] const Axis& y() const { return y_; }
  [[nodiscard]] std::size_t size() const { return x_.size() * y_.size(); }
  [[nodiscard]] bool wraps() const { return wraps_; }

  [[nodiscard]] geo::LonLat place(std::size_t ix, std::size_t iy) const;
  /// Outside  nullopt outside the outermost nodes
  [[nodiscard]] std::optional<GridPosition> locate(geo::LonLat place) const;
  /// `point`  in the grid's own coordinates
  [[nodiscard]] std::optional<GridPosition> locate_point(geo::GridPoint point) const;
  /// The position of a meridian or another line of constant x among the columns. Outside: nullopt.
  [[nodiscard]] std::optional<AxisPosition> locate_column(double x) const;
  /// Smallest box of longitudes and latitudes that contains every node.
  [[nodiscard]] geo::BoundingBox bounds() const;
  /// Typical distance on the ground between neighbouring nodes, measured at the centre; the smaller of the
  /// two directions.
  [[nodiscard]] core::Metres spacing() const;

 private:
  geo::FrameProjection projection_;
  Axis x_;
  Axis y_;
  bool wraps_{false};
};

}  // namespace floeplan::ocean
