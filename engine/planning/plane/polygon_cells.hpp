#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/geo/polygon.hpp"
#include "engine/planning/plane/coast_lines.hpp"
#include "engine/planning/plane/plane_raster.hpp"

namespace floeplan::planning::plane {

/// Calls `inside(cell)` for every cell of the raster whose centre lies in the polygon. Then calls
/// `on_outline(cell)` for every cell that the outline, or that of a hole, enters; these cells may have been
/// inside as well.
template <class Inside, class OnOutline>
void visit_cells(const geo::Polygon& polygon, const PlaneRaster& raster,
                 const geo::LocalProjection& projection, Inside&& inside, OnOutline&& on_outline) {
  if (polygon.outer.empty()) return;
  const PlaneBox& area = raster.area();
  const PlaneBox reach = area.grown(raster.cell_m());
  // Even-odd filling by rows, along the line through the cell centres of each row. Crossings with holes
  // count, too.
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(raster.ny()));
  std::vector<std::size_t> outline;

  const auto add_line = [&](geo::PlanePoint a, geo::PlanePoint b) {
    PlaneBox line{a, a};
    line.include(b);
    if (line.high.x_m >= reach.low.x_m && line.low.x_m <= reach.high.x_m && line.high.y_m >= reach.low.y_m &&
        line.low.y_m <= reach.high.y_m) {
      raster.for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
        if (raster.holds(ix, iy)) outline.push_back(raster.index(ix, iy));
        return true;
      });
    }
    const auto row_of = [&](double y_m) { return (y_m - area.low.y_m) / raster.cell_m() - 0.5; };
    const double from = std::min(row_of(a.y_m), row_of(b.y_m));
    const double to = std::max(row_of(a.y_m), row_of(b.y_m));
    const auto first = static_cast<std::int64_t>(std::max(0.0, std::floor(from) + 1.0));
    const auto last =
        static_cast<std::int64_t>(std::min(static_cast<double>(raster.ny() - 1), std::floor(to)));
    for (std::int64_t row = first; row <= last; ++row) {
      const double y_m = area.low.y_m + (static_cast<double>(row) + 0.5) * raster.cell_m();
      crossings[static_cast<std::size_t>(row)].push_back(a.x_m +
                                                         (y_m - a.y_m) / (b.y_m - a.y_m) * (b.x_m - a.x_m));
    }
  };
  for_each_coast_line(polygon.outer, projection, add_line);
  for (const geo::Ring& hole : polygon.holes) for_each_coast_line(hole, projection, add_line);

  for (std::int64_t row = 0; row < raster.ny(); ++row) {
    auto& crossed = crossings[static_cast<std::size_t>(row)];
    std::ranges::sort(crossed);
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
      const double from = (crossed[i] - area.low.x_m) / raster.cell_m() - 0.5;
      const double to = (crossed[i + 1] - area.low.x_m) / raster.cell_m() - 0.5;
      const auto first = static_cast<std::int64_t>(std::max(0.0, std::ceil(from)));
      const auto last =
          static_cast<std::int64_t>(std::min(static_cast<double>(raster.nx() - 1), std::floor(to)));
      for (std::int64_t ix = first; ix <= last; ++ix) inside(raster.index(ix, row));
    }
  }
  for (const std::size_t cell : outline) on_outline(cell);
}

}  // namespace floeplan::planning::plane
