#include "engine/planning/obstacles/least_depth_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <variant>

namespace floeplan::planning::obstacles {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/// Appends the nodes between `from` and `to`. With `goes_round`, nodes of the next turn are included if longitudes
/// run on beyond the seam.
void add_nodes_between(std::vector<ocean::AxisPosition>& lines, const ocean::Axis& axis, double from,
                       double to, bool goes_round) {
  const auto add = [&](double turn) {
    const std::vector<double>& nodes = axis.nodes();
    for (auto node = std::ranges::upper_bound(nodes, from - turn); node != nodes.end() && *node + turn < to;
         ++node) {
      const auto index = static_cast<std::size_t>(node - nodes.begin());
      lines.push_back({index, index, 0.0});
    }
  };
  add(0.0);
  if (goes_round && to >= axis.front() + 360.0) add(360.0);
}

}  // namespace

LeastDepthRows::LeastDepthRows(const plane::PlaneRaster& raster, const ocean::Bathymetry& bathymetry,
                               core::Metres enough, const geo::LocalProjection& projection,
                               const std::stop_token& stop)
    : raster_{raster},
      bathymetry_{bathymetry},
      enough_m_{static_cast<float>(enough.value)},
      geographic_{std::holds_alternative<geo::GeographicFrame>(bathymetry.grid().frame())},
      columns_{bathymetry.grid().x().nodes()},
      rows_{bathymetry.grid().y().nodes()},
      lookup_{bathymetry.grid().frame(), projection, raster.area().grown(raster.cell_m()), stop},
      below_(static_cast<std::size_t>(raster.nx() + 1)),
      above_(below_.size()),
      least_m_(static_cast<std::size_t>(raster.nx())) {
  fill(0, above_);
}

const std::vector<float>& LeastDepthRows::next() {
  std::swap(below_, above_);
  fill(++row_, above_);
  for (std::size_t i = 0; i < least_m_.size(); ++i)
    least_m_[i] = least_of(below_[i], below_[i + 1], above_[i], above_[i + 1]);
  return least_m_;
}

void LeastDepthRows::fill(std::int64_t iy, std::vector<Corner>& corners) const {
  const ocean::HorizontalGrid& grid = bathymetry_.grid();
  const double y_m = raster_.area().low.y_m + raster_.cell_m() * static_cast<double>(iy);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    geo::GridPoint at =
        lookup_.coordinates({raster_.area().low.x_m + raster_.cell_m() * static_cast<double>(i), y_m});
    if (geographic_) at.x -= 360.0 * std::floor((at.x - grid.x().front()) / 360.0 + 1e-9);
    corners[i] = {at.x, at.y, columns_.locate(at.x), rows_.locate(at.y)};
  }
}

float LeastDepthRows::least_of(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  auto [west, east] = std::minmax({a.x, b.x, c.x, d.x});
  auto [south, north] = std::minmax({a.y, b.y, c.y, d.y});
  if (!geographic_ || east - west < 180.0) {
    const auto least = least_node(a, b, c, d);
    return least && *least >= enough_m_ ? *least : least_in_box(west, south, east, north);
  }
  // The cell crosses the seam of the longitudes, or contains a pole.
  const double middle = west + 180.0;
  const auto onwards = [&](const Corner& corner) { return corner.x < middle ? corner.x + 360.0 : corner.x; };
  std::tie(west, east) = std::minmax({onwards(a), onwards(b), onwards(c), onwards(d)});
  if (east - west < 180.0) return least_in_box(west, south, east, north);
  if (north > 0.0) return least_in_box(west, south, west + 360.0, 90.0);
  return least_in_box(west, -90.0, west + 360.0, north);
}

std::optional<float> LeastDepthRows::least_node(const Corner& a, const Corner& b, const Corner& c,
                                                const Corner& d) const {
  if (!a.column || !b.column || !c.column || !d.column || !a.row || !b.row || !c.row || !d.row)
    return std::nullopt;
  const auto [first_column, last_column] =
      std::minmax({a.column->cell, b.column->cell, c.column->cell, d.column->cell});
  const auto [first_row, last_row] = std::minmax({a.row->cell, b.row->cell, c.row->cell, d.row->cell});
  const std::vector<float>& depths_m = bathymetry_.shoalest_m();
  const std::size_t columns = bathymetry_.grid().x().size();
  float least_m = std::numeric_limits<float>::infinity();
  for (std::size_t row = first_row; row <= last_row + 1; ++row) {
    for (std::size_t column = first_column; column <= last_column + 1; ++column) {
      const float depth_m = depths_m[row * columns + column];
      if (!(depth_m >= enough_m_)) return std::nullopt;
      least_m = std::min(least_m, depth_m);
    }
  }
  return least_m;
}

float LeastDepthRows::least_in_box(double west, double south, double east, double north) {
  const ocean::HorizontalGrid& grid = bathymetry_.grid();
  bool all_known = true;
  const auto add = [&](std::vector<ocean::AxisPosition>& lines, const auto& position) {
    all_known = all_known && position.has_value();
    if (position) lines.push_back(*position);
  };
  columns_of_box_.clear();
  add(columns_of_box_, grid.locate_column(west));
  add_nodes_between(columns_of_box_, grid.x(), west, east, geographic_);
  add(columns_of_box_, grid.locate_column(east));
  rows_of_box_.clear();
  add(rows_of_box_, grid.y().locate(south));
  add_nodes_between(rows_of_box_, grid.y(), south, north, false);
  add(rows_of_box_, grid.y().locate(north));
  float least_m = std::numeric_limits<float>::infinity();
  for (const ocean::AxisPosition& row : rows_of_box_) {
    for (const ocean::AxisPosition& column : columns_of_box_) {
      const auto depth = bathymetry_.shoalest_at(ocean::GridPosition{column, row});
      all_known = all_known && depth.has_value();
      if (!depth) continue;
      const auto depth_m = static_cast<float>(depth->value);
      if (depth_m <= 0.0F) return depth_m;
      least_m = std::min(least_m, depth_m);
    }
  }
  return all_known ? least_m : unknown;
}

}  // namespace floeplan::planning::obstacles
