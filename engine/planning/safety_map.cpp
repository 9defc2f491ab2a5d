#include "engine/planning/safety_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/planning/coast_lines.hpp"
#include "engine/planning/grid_lookup.hpp"

namespace floeplan::planning {
namespace {

constexpr double longest_coast_piece_deg =
    0.1;  // longer straight lines of longitude and latitude bend in the plane

std::optional<motion::EdgeClosed> judge(std::optional<core::Metres> depth, core::Metres least_depth) {
  if (!depth) return motion::EdgeClosed::outside_data;
  if (depth->value <= 0.0) return motion::EdgeClosed::on_land;
  if (*depth < least_depth) return motion::EdgeClosed::too_shallow;
  return std::nullopt;
}

}  // namespace

SafetyMap::SafetyMap(const ocean::Environment& environment, core::Metres least_depth,
                     const geo::LocalProjection& projection, const PlaneBox& area, core::Metres cell,
                     const std::stop_token& stop)
    : environment_{&environment},
      least_depth_{least_depth},
      projection_{projection},
      area_{area},
      cell_m_{cell.value},
      nx_{std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(area.width_m() / cell.value)))},
      ny_{std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(area.height_m() / cell.value)))},
      cells_(static_cast<std::size_t>(nx_ * ny_), Cell::open) {
  if (environment.bathymetry) close_shallow_cells(stop);
  close_land_cells(environment.land, stop);
  measure_clearance(stop);
}

std::optional<std::size_t> SafetyMap::index(geo::PlanePoint point) const {
  const auto ix = static_cast<std::int64_t>(std::floor((point.x_m - area_.low.x_m) / cell_m_));
  const auto iy = static_cast<std::int64_t>(std::floor((point.y_m - area_.low.y_m) / cell_m_));
  if (ix < 0 || ix >= nx_ || iy < 0 || iy >= ny_) return std::nullopt;
  return static_cast<std::size_t>(iy * nx_ + ix);
}

void SafetyMap::close_shallow_cells(const std::stop_token& stop) {
  const ocean::Bathymetry& bathymetry = *environment_->bathymetry;
  const ocean::HorizontalGrid& grid = bathymetry.grid();
  const GridLookup lookup{grid.frame(), projection_, area_.grown(cell_m_), stop};
  const bool geographic = std::holds_alternative<geo::GeographicFrame>(grid.frame());

  const auto corner_coordinates = [&](std::int64_t ix, std::int64_t iy) {
    geo::GridPoint at = lookup.coordinates({area_.low.x_m + cell_m_ * static_cast<double>(ix),
                                            area_.low.y_m + cell_m_ * static_cast<double>(iy)});
    if (geographic) at.x -= 360.0 * std::floor((at.x - grid.x().front()) / 360.0 + 1e-9);
    return at;
  };
  const auto depth_at = [&](const geo::GridPoint& at) -> std::optional<core::Metres> {
    if (geographic) return bathymetry.depth({at.x, at.y});
    return bathymetry.depth(geo::to_lon_lat(grid.frame(), at));
  };

  std::vector<geo::GridPoint> below(static_cast<std::size_t>(nx_ + 1));
  std::vector<geo::GridPoint> above(below.size());
  std::vector<std::optional<core::Metres>> depth_below(below.size());
  std::vector<std::optional<core::Metres>> depth_above(below.size());
  const auto fill_row = [&](std::int64_t iy, auto& coordinates, auto& depths) {
    for (std::int64_t ix = 0; ix <= nx_; ++ix) {
      const auto i = static_cast<std::size_t>(ix);
      coordinates[i] = corner_coordinates(ix, iy);
      depths[i] = depth_at(coordinates[i]);
    }
  };
  const auto depth_of_node = [&](std::size_t ix, std::size_t iy) -> std::optional<core::Metres> {
    const float depth_m = bathymetry.depth_m()[iy * grid.x().size() + ix];
    if (std::isnan(depth_m)) return std::nullopt;
    return core::Metres{static_cast<double>(depth_m)};
  };

  fill_row(0, below, depth_below);
  for (std::int64_t iy = 0; iy < ny_ && !stop.stop_requested(); ++iy) {
    fill_row(iy + 1, above, depth_above);
    for (std::int64_t ix = 0; ix < nx_; ++ix) {
      const auto i = static_cast<std::size_t>(ix);
      std::optional<motion::EdgeClosed> worst;
      const auto worsen = [&](const std::optional<core::Metres>& depth) {
        const auto verdict = judge(depth, least_depth_);
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
      cells_[static_cast<std::size_t>(iy * nx_ + ix)] = *worst == motion::EdgeClosed::on_land ? Cell::on_land
                                                        : *worst == motion::EdgeClosed::too_shallow
                                                            ? Cell::too_shallow
                                                            : Cell::outside_data;
    }
    std::swap(below, above);
    std::swap(depth_below, depth_above);
  }
}

template <class Visit>
void SafetyMap::for_each_cell(geo::PlanePoint a, geo::PlanePoint b, Visit&& visit) const {
  // Walks the cells in the order the line enters them (Amanatides and Woo 1987, A fast voxel traversal
  // algorithm).
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
    if (!visit(ix, iy) || left-- == 0) return;
    if (next_x < next_y) {
      ix += step_x;
      next_x += per_x;
    } else {
      iy += step_y;
      next_y += per_y;
    }
  }
}

void SafetyMap::close_along(geo::PlanePoint a, geo::PlanePoint b) {
  for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
    if (ix >= 0 && ix < nx_ && iy >= 0 && iy < ny_)
      cells_[static_cast<std::size_t>(iy * nx_ + ix)] = Cell::on_land;
    return true;
  });
}

void SafetyMap::close_land_cells(const std::vector<geo::Polygon>& land, const std::stop_token& stop) {
  if (land.empty()) return;
  // Even-odd filling by rows through the middle of the cells; every crossing of a row's middle line, holes
  // included.
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(ny_));
  const PlaneBox reach = area_.grown(cell_m_);

  const auto add_line = [&](geo::PlanePoint a, geo::PlanePoint b) {
    PlaneBox line{a, a};
    line.include(b);
    if (line.high.x_m >= reach.low.x_m && line.low.x_m <= reach.high.x_m && line.high.y_m >= reach.low.y_m &&
        line.low.y_m <= reach.high.y_m) {
      close_along(a, b);
    }
    const auto row_of = [&](double y_m) { return (y_m - area_.low.y_m) / cell_m_ - 0.5; };
    const double from = std::min(row_of(a.y_m), row_of(b.y_m));
    const double to = std::max(row_of(a.y_m), row_of(b.y_m));
    const auto first = static_cast<std::int64_t>(std::max(0.0, std::floor(from) + 1.0));
    const auto last = static_cast<std::int64_t>(std::min(static_cast<double>(ny_ - 1), std::floor(to)));
    for (std::int64_t row = first; row <= last; ++row) {
      const double y_m = area_.low.y_m + (static_cast<double>(row) + 0.5) * cell_m_;
      crossings[static_cast<std::size_t>(row)].push_back(a.x_m +
                                                         (y_m - a.y_m) / (b.y_m - a.y_m) * (b.x_m - a.x_m));
    }
  };
  for (const geo::Polygon& polygon : land) {
    if (stop.stop_requested()) return;
    if (polygon.outer.empty()) continue;
    for_each_coast_line(polygon.outer, projection_, add_line);
    for (const geo::Ring& hole : polygon.holes) for_each_coast_line(hole, projection_, add_line);
    for (std::int64_t row = 0; row < ny_; ++row) {
      auto& crossed = crossings[static_cast<std::size_t>(row)];
      std::ranges::sort(crossed);
      for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
        const double from = (crossed[i] - area_.low.x_m) / cell_m_ - 0.5;
        const double to = (crossed[i + 1] - area_.low.x_m) / cell_m_ - 0.5;
        const auto first = static_cast<std::int64_t>(std::max(0.0, std::ceil(from)));
        const auto last = static_cast<std::int64_t>(std::min(static_cast<double>(nx_ - 1), std::floor(to)));
        for (std::int64_t ix = first; ix <= last; ++ix)
          cells_[static_cast<std::size_t>(row * nx_ + ix)] = Cell::on_land;
      }
      crossed.clear();
    }
  }
}

void SafetyMap::measure_clearance(const std::stop_token& stop) {
  // Distance in cells by two sweeps over the eight neighbours; beyond the raster nothing is open.
  constexpr int most = 255;
  clearance_.assign(cells_.size(), 0);
  const auto at = [&](std::int64_t ix, std::int64_t iy) -> int {
    if (ix < 0 || ix >= nx_ || iy < 0 || iy >= ny_) return 0;
    return clearance_[static_cast<std::size_t>(iy * nx_ + ix)];
  };
  for (std::int64_t iy = 0; iy < ny_ && !stop.stop_requested(); ++iy) {
    for (std::int64_t ix = 0; ix < nx_; ++ix) {
      const auto i = static_cast<std::size_t>(iy * nx_ + ix);
      if (cells_[i] != Cell::open) continue;
      const int least = std::min({at(ix - 1, iy), at(ix - 1, iy - 1), at(ix, iy - 1), at(ix + 1, iy - 1)});
      clearance_[i] = static_cast<std::uint8_t>(std::min(least + 1, most));
    }
  }
  for (std::int64_t iy = ny_ - 1; iy >= 0 && !stop.stop_requested(); --iy) {
    for (std::int64_t ix = nx_ - 1; ix >= 0; --ix) {
      const auto i = static_cast<std::size_t>(iy * nx_ + ix);
      if (cells_[i] != Cell::open) continue;
      const int least = std::min({at(ix + 1, iy), at(ix + 1, iy + 1), at(ix, iy + 1), at(ix - 1, iy + 1)});
      clearance_[i] = static_cast<std::uint8_t>(std::min({static_cast<int>(clearance_[i]), least + 1, most}));
    }
  }
}

std::optional<motion::EdgeClosed> SafetyMap::closed_between(geo::PlanePoint a, geo::PlanePoint b) const {
  const auto start = index(a);
  if (!start || !index(b)) return motion::EdgeClosed::outside_data;
  const double reach_m = std::max(std::abs(b.x_m - a.x_m), std::abs(b.y_m - a.y_m));
  // A clearance of n leaves at least n - 1 whole open cells around the one the line starts in.
  if (reach_m <= (clearance_[*start] - 1) * cell_m_) return std::nullopt;

  std::optional<motion::EdgeClosed> closed;
  for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
    switch (cells_[static_cast<std::size_t>(iy * nx_ + ix)]) {
      case Cell::open: return true;
      case Cell::too_shallow: closed = motion::EdgeClosed::too_shallow; return false;
      case Cell::on_land: closed = motion::EdgeClosed::on_land; return false;
      case Cell::outside_data: closed = motion::EdgeClosed::outside_data; return false;
    }
    return false;
  });
  return closed;
}

std::optional<motion::EdgeClosed> SafetyMap::closed_at(geo::LonLat place) const {
  for (const geo::Polygon& polygon : environment_->land) {
    if (geo::contains(polygon, place)) return motion::EdgeClosed::on_land;
  }
  if (!environment_->bathymetry) return std::nullopt;
  return judge(environment_->bathymetry->depth(place), least_depth_);
}

void SafetyMap::open_around(geo::PlanePoint point) {
  const auto i = index(point);
  if (!i || cells_[*i] == Cell::open) return;
  cells_[*i] = Cell::open;
  clearance_[*i] = 1;
}

}  // namespace floeplan::planning
