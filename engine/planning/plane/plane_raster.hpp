#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// Square cells over an area of the plane, numbered row by row from the lower left corner. Geometry only: the
/// user stores values for the cells.
/// Threads  const members may be called from several threads at once
class PlaneRaster {
 public:
  PlaneRaster(const PlaneBox& area, core::Metres cell)
      : area_{area},
        cell_m_{cell.value},
        nx_{std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(area.width_m() / cell.value)))},
        ny_{std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(area.height_m() / cell.value)))} {}

  [[nodiscard]] const PlaneBox& area() const { return area_; }
  [[nodiscard]] double cell_m() const { return cell_m_; }
  [[nodiscard]] std::int64_t nx() const { return nx_; }
  [[nodiscard]] std::int64_t ny() const { return ny_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(nx_ * ny_); }
  [[nodiscard]] bool holds(std::int64_t ix, std::int64_t iy) const {
    return ix >= 0 && ix < nx_ && iy >= 0 && iy < ny_;
  }
  /// Precondition: the cell lies in the raster.
  [[nodiscard]] std::size_t index(std::int64_t ix, std::int64_t iy) const {
    return static_cast<std::size_t>(iy * nx_ + ix);
  }
  [[nodiscard]] geo::PlanePoint centre(std::size_t cell) const {
    const auto i = static_cast<std::int64_t>(cell);
    return {area_.low.x_m + (static_cast<double>(i % nx_) + 0.5) * cell_m_,
            area_.low.y_m + (static_cast<double>(i / nx_) + 0.5) * cell_m_};
  }
  /// The cell of a point; empty outside the raster.
  [[nodiscard]] std::optional<std::size_t> index(geo::PlanePoint point) const {
    const auto ix = static_cast<std::int64_t>(std::floor((point.x_m - area_.low.x_m) / cell_m_));
    const auto iy = static_cast<std::int64_t>(std::floor((point.y_m - area_.low.y_m) / cell_m_));
    if (!holds(ix, iy)) return std::nullopt;
    return index(ix, iy);
  }

  /// Calls `visit(ix, iy)` for every cell that the straight line from a to b enters, in order, until it
  /// returns false. Cells outside the raster are visited, too.
  template <class Visit>
  void for_each_cell(geo::PlanePoint a, geo::PlanePoint b, Visit&& visit) const {
    for_each_stretch(a, b, [&](std::int64_t ix, std::int64_t iy, double) { return visit(ix, iy); });
  }

  /// As `for_each_cell`, also with the share of the line at which it leaves the cell: `visit(ix, iy, until)`;
  /// 1 in the last.
  /// Source   Amanatides and Woo 1987, A fast voxel traversal algorithm for ray tracing, Eurographics
  template <class Visit>
  void for_each_stretch(geo::PlanePoint a, geo::PlanePoint b, Visit&& visit) const {
    const double ax = (a.x_m - area_.low.x_m) / cell_m_;
    const double ay = (a.y_m - area_.low.y_m) / cell_m_;
    const double bx = (b.x_m - area_.low.x_m) / cell_m_;
    const double by = (b.y_m - area_.low.y_m) / cell_m_;
    auto ix = static_cast<std::int64_t>(std::floor(ax));
    auto iy = static_cast<std::int64_t>(std::floor(ay));
    const auto end_x = static_cast<std::int64_t>(std::floor(bx));
    const auto end_y = static_cast<std::int64_t>(std::floor(by));
    const std::int64_t step_x = bx > ax ? 1 : -1;
    const std::int64_t step_y = by > ay ? 1 : -1;
    const double infinite = std::numeric_limits<double>::infinity();
    const double per_x = bx != ax ? 1.0 / std::abs(bx - ax) : infinite;
    const double per_y = by != ay ? 1.0 / std::abs(by - ay) : infinite;
    const auto to_border = [](double at, std::int64_t cell, std::int64_t step) {
      return step > 0 ? static_cast<double>(cell + 1) - at : at - static_cast<double>(cell);
    };
    double next_x = bx != ax ? to_border(ax, ix, step_x) * per_x : infinite;
    double next_y = by != ay ? to_border(ay, iy, step_y) * per_y : infinite;

    std::int64_t left = std::abs(end_x - ix) + std::abs(end_y - iy);
    for (;;) {
      const double until = left == 0 ? 1.0 : std::min({next_x, next_y, 1.0});
      if (!visit(ix, iy, until) || left-- == 0) return;
      if (next_x < next_y) {
        ix += step_x;
        next_x += per_x;
      } else {
        iy += step_y;
        next_y += per_y;
      }
    }
  }

 private:
  PlaneBox area_;
  double cell_m_;
  std::int64_t nx_;
  std::int64_t ny_;
};

}  // namespace floeplan::planning::plane
