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

/// An edge of a box, or a grid line of the data that crosses it.
struct Line {
  double at;
  std::optional<std::size_t> node{};
};

/// The lines at both ends of the interval, and the nodes between. With `goes_round`, nodes of the next turn
/// are included if longitudes run on beyond the seam.
std::vector<Line> lines_between(const ocean::Axis& axis, double from, double to, bool goes_round) {
  std::vector<Line> lines{{from}};
  const auto add = [&](double turn) {
    const std::vector<double>& nodes = axis.nodes();
    for (auto node = std::ranges::upper_bound(nodes, from - turn); node != nodes.end() && *node + turn < to;
         ++node)
      lines.push_back({*node + turn, static_cast<std::size_t>(node - nodes.begin())});
  };
  add(0.0);
  if (goes_round && to >= axis.front() + 360.0) add(360.0);
  lines.push_back({to});
  return lines;
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

float LeastDepthRows::least_of(const Corner& a, const Corner& b, const Corner& c, const Corner& d) const {
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

float LeastDepthRows::least_in_box(double west, double south, double east, double north) const {
  const ocean::HorizontalGrid& grid = bathymetry_.grid();
  const std::vector<Line> xs = lines_between(grid.x(), west, east, geographic_);
  const std::vector<Line> ys = lines_between(grid.y(), south, north, false);
  float least_m = std::numeric_limits<float>::infinity();
  bool all_known = true;
  for (const Line& y : ys) {
    for (const Line& x : xs) {
      const float depth_m = x.node && y.node ? bathymetry_.shoalest_m()[*y.node * grid.x().size() + *x.node]
                                             : depth_at(x.at, y.at);
      if (depth_m <= 0.0F) return depth_m;
      if (std::isnan(depth_m)) all_known = false;
      if (depth_m < least_m) least_m = depth_m;
    }
  }
  return all_known ? least_m : unknown;
}

float LeastDepthRows::depth_at(double x, double y) const {
  const auto depth = bathymetry_.shoalest_at({x, y});
  return depth ? static_cast<float>(depth->value) : unknown;
}

}  // namespace floeplan::planning::obstacles
