#include "engine/ocean/grids/node_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floeplan::ocean {
namespace {

struct Extremes {
  double least{std::numeric_limits<double>::infinity()};
  double most{-std::numeric_limits<double>::infinity()};

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  [[nodiscard]] double width() const { return most - least; }
};

struct Run {
  std::size_t first{};
  std::size_t count{};
};

Run nodes_within(const Axis& axis, double from, double to) {
  const auto& nodes = axis.nodes();
  const auto first = std::lower_bound(nodes.begin(), nodes.end(), from);
  const auto end = std::upper_bound(first, nodes.end(), to);
  return {static_cast<std::size_t>(first - nodes.begin()), static_cast<std::size_t>(end - first)};
}

/// Columns between two meridians; after the last column the range continues at the first.
Run columns_within(const Axis& lons, double from, double width) {
  const double start = from - 360.0 * std::floor((from - lons.front()) / 360.0);
  Run run = nodes_within(lons, start, start + width);
  const Run next_turn = nodes_within(lons, lons.front(), start + width - 360.0);
  if (run.count == 0) return next_turn;
  run.count = std::min(run.count + next_turn.count, lons.size());
  return run;
}

/// Sides are great circles. Between two corners this many degrees of longitude apart, a side may come nearer
/// to the pole than the corners, by at most this many degrees.
double bulge_deg(double width_deg) { return width_deg * width_deg * std::numbers::pi / 180.0 / 8.0; }

/// The nodes by longitudes and latitudes, for cells across the meridian from which positions count or near a pole.
NodeBox geographic_box(const HorizontalGrid& grid, const Mesh& mesh, const Mesh::Cell& cell,
                       double beside_lon_deg, double beside_lat_deg) {
  Extremes lon;
  Extremes lat;
  double turned = 0.0;  // sum of longitude changes around the cell
  const geo::LonLat first = mesh.points[cell[0]];
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const geo::LonLat corner = mesh.points[cell[i]];
    const geo::LonLat next = mesh.points[cell[(i + 1) % cell.size()]];
    lon.add(geo::longitude_difference(first.lon_deg, corner.lon_deg));
    lat.add(corner.lat_deg);
    turned += geo::longitude_difference(corner.lon_deg, next.lon_deg);
  }
  const bool round_a_pole = std::abs(turned) > 180.0 || lat.most > 89.999 || lat.least < -89.999;
  if (round_a_pole) {
    const bool north = lat.most > 0.0;
    const Run y = north ? nodes_within(grid.y(), lat.least - beside_lat_deg - 1e-9, 90.0)
                        : nodes_within(grid.y(), -90.0, lat.most + beside_lat_deg + 1e-9);
    return {0, grid.x().size(), y.first, y.count};
  }
  const double bulge = bulge_deg(lon.width()) + beside_lat_deg + 1e-6;
  const double beside = beside_lon_deg + 1e-6;
  const Run x = columns_within(grid.x(), first.lon_deg + lon.least - beside, lon.width() + 2.0 * beside);
  const Run y = nodes_within(grid.y(), lat.least - bulge, lat.most + bulge);
  return {x.first, x.count, y.first, y.count};
}

/// Distance of neighbouring nodes; 1 for a single node.
double step_of(const Axis& axis) { return axis.size() > 1 ? axis[1] - axis[0] : 1.0; }

/// The nodes between two positions.
Run nodes_between(const Axis& axis, double from, double to) {
  const double last = static_cast<double>(axis.size() - 1);
  if (!(to >= 0.0 && from <= last)) return {};
  const auto first = static_cast<std::size_t>(std::max(std::ceil(from), 0.0));
  auto end = static_cast<std::size_t>(std::min(std::floor(to), last)) + 1;
  if (end + 1 == axis.size()) ++end;  // the last step may be shorter
  return end > first ? Run{first, end - first} : Run{};
}

}  // namespace

NodeBoxes::NodeBoxes(const HorizontalGrid& grid, const Mesh& mesh)
    : grid_{grid},
      mesh_{mesh},
      is_geographic_{std::holds_alternative<geo::GeographicFrame>(grid.frame())},
      step_x_{step_of(grid.x())},
      step_y_{step_of(grid.y())} {
  positions_.reserve(mesh.points.size());
  for (const geo::LonLat point : mesh.points) positions_.push_back(position_of(point));
}

NodeBoxes::Position NodeBoxes::position_of(geo::LonLat point) const {
  if (!is_geographic_) {
    const geo::GridPoint at = grid_.projection().to_grid(point);
    return {(at.x - grid_.x().front()) / step_x_, (at.y - grid_.y().front()) / step_y_};
  }
  const double middle_deg = 0.5 * (grid_.x().front() + grid_.x().back());
  const double lon_deg = middle_deg + geo::longitude_difference(middle_deg, point.lon_deg);
  return {(lon_deg - grid_.x().front()) / step_x_, (point.lat_deg - grid_.y().front()) / step_y_};
}

NodeBox NodeBoxes::near_or_beside(const Mesh::Cell& cell) const {
  const NodeBox box = near(cell);
  return box.count_x > 0 && box.count_y > 0 ? box : within(cell, 1.0);
}

NodeBox NodeBoxes::within(const Mesh::Cell& cell, double steps) const {
  constexpr double hair = 1e-6;  // of a step
  constexpr double near_pole_deg = 89.9;
  Extremes x;
  Extremes y;
  double farthest_deg = 0.0;
  for (const std::uint32_t corner : cell) {
    x.add(positions_[corner].x);
    y.add(positions_[corner].y);
    farthest_deg = std::max(farthest_deg, std::abs(mesh_.points[corner].lat_deg));
  }
  double beside_x = steps + hair;
  double beside_y = steps + hair;
  if (is_geographic_) {
    const double width_deg = x.width() * step_x_;
    if (width_deg > 180.0 || farthest_deg > near_pole_deg)
      return geographic_box(grid_, mesh_, cell, steps * step_x_, steps * step_y_);
    beside_y += bulge_deg(width_deg) / step_y_;
  } else {  // sides that are straight on the sphere bend slightly on the plane
    const double bent = 0.1 * std::max(x.width() * step_x_, y.width() * step_y_);
    beside_x += bent / step_x_;
    beside_y += bent / step_y_;
  }
  const Run columns = nodes_between(grid_.x(), x.least - beside_x, x.most + beside_x);
  const Run rows = nodes_between(grid_.y(), y.least - beside_y, y.most + beside_y);
  return {columns.first, columns.count, rows.first, rows.count};
}

}  // namespace floeplan::ocean
