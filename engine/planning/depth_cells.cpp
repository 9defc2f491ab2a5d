#include "engine/planning/depth_cells.hpp"

#include <algorithm>
#include <cmath>

#include "engine/planning/grid_lookup.hpp"

namespace floeplan::planning {

std::optional<motion::EdgeClosed> judge_depth(std::optional<core::Metres> depth, core::Metres least_depth) {
  if (!depth) return motion::EdgeClosed::outside_data;
  if (depth->value <= 0.0) return motion::EdgeClosed::on_land;
  if (*depth < least_depth) return motion::EdgeClosed::too_shallow;
  return std::nullopt;
}

std::vector<CellState> judge_depths(const PlaneRaster& raster, const ocean::Bathymetry& bathymetry,
                                    core::Metres least_depth, const geo::LocalProjection& projection,
                                    const std::stop_token& stop) {
  std::vector<CellState> cells(raster.size(), CellState::open);
  const PlaneBox& area = raster.area();
  const double cell_m = raster.cell_m();
  const ocean::HorizontalGrid& grid = bathymetry.grid();
  const GridLookup lookup{grid.frame(), projection, area.grown(cell_m), stop};
  const bool geographic = std::holds_alternative<geo::GeographicFrame>(grid.frame());

  const auto corner_coordinates = [&](std::int64_t ix, std::int64_t iy) {
    geo::GridPoint at = lookup.coordinates(
        {area.low.x_m + cell_m * static_cast<double>(ix), area.low.y_m + cell_m * static_cast<double>(iy)});
    if (geographic) at.x -= 360.0 * std::floor((at.x - grid.x().front()) / 360.0 + 1e-9);
    return at;
  };
  const auto depth_at = [&](const geo::GridPoint& at) -> std::optional<core::Metres> {
    if (geographic) return bathymetry.shoalest({at.x, at.y});
    return bathymetry.shoalest(geo::to_lon_lat(grid.frame(), at));
  };

  std::vector<geo::GridPoint> below(static_cast<std::size_t>(raster.nx() + 1));
  std::vector<geo::GridPoint> above(below.size());
  std::vector<std::optional<core::Metres>> depth_below(below.size());
  std::vector<std::optional<core::Metres>> depth_above(below.size());
  const auto fill_row = [&](std::int64_t iy, auto& coordinates, auto& depths) {
    for (std::int64_t ix = 0; ix <= raster.nx(); ++ix) {
      const auto i = static_cast<std::size_t>(ix);
      coordinates[i] = corner_coordinates(ix, iy);
      depths[i] = depth_at(coordinates[i]);
    }
  };
  const auto depth_of_node = [&](std::size_t ix, std::size_t iy) -> std::optional<core::Metres> {
    const float depth_m = bathymetry.shoalest_m()[iy * grid.x().size() + ix];
    if (std::isnan(depth_m)) return std::nullopt;
    return core::Metres{static_cast<double>(depth_m)};
  };

  fill_row(0, below, depth_below);
  for (std::int64_t iy = 0; iy < raster.ny() && !stop.stop_requested(); ++iy) {
    fill_row(iy + 1, above, depth_above);
    for (std::int64_t ix = 0; ix < raster.nx(); ++ix) {
      const auto i = static_cast<std::size_t>(ix);
      std::optional<motion::EdgeClosed> worst;
      const auto worsen = [&](const std::optional<core::Metres>& depth) {
        const auto verdict = judge_depth(depth, least_depth);
        if (verdict && (!worst || *verdict == motion::EdgeClosed::on_land)) worst = verdict;
      };
      worsen(depth_below[i]);
      worsen(depth_below[i + 1]);
      worsen(depth_above[i]);
      worsen(depth_above[i + 1]);

      const auto [west, east] = std::minmax({below[i].x, below[i + 1].x, above[i].x, above[i + 1].x});
      const auto [south, north] = std::minmax({below[i].y, below[i + 1].y, above[i].y, above[i + 1].y});
      if (east - west < 180.0 || !geographic) {
        const auto& xs = grid.x().nodes();
        const auto& ys = grid.y().nodes();
        for (auto y = std::ranges::lower_bound(ys, south); y != ys.end() && *y <= north; ++y) {
          for (auto x = std::ranges::lower_bound(xs, west); x != xs.end() && *x <= east; ++x) {
            worsen(depth_of_node(static_cast<std::size_t>(x - xs.begin()),
                                 static_cast<std::size_t>(y - ys.begin())));
          }
        }
      }
      if (!worst) continue;
      cells[raster.index(ix, iy)] = *worst == motion::EdgeClosed::on_land       ? CellState::on_land
                                    : *worst == motion::EdgeClosed::too_shallow ? CellState::too_shallow
                                                                                : CellState::outside_data;
    }
    std::swap(below, above);
    std::swap(depth_below, depth_above);
  }
  return cells;
}

}  // namespace floeplan::planning
