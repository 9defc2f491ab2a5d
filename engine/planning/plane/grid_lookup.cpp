#include "engine/planning/plane/grid_lookup.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::plane {
namespace {

constexpr double finest_step_m = 2000.0;
constexpr double most_cells_a_side = 1000.0;
constexpr double jump_deg = 90.0;  // a table cell spans less, unless longitude jumps inside it

}  // namespace

GridLookup::GridLookup(const geo::GridFrame& frame, const geo::LocalProjection& projection,
                       const PlaneBox& area, const std::stop_token& stop)
    : frame_{frame},
      is_geographic_{std::holds_alternative<geo::GeographicFrame>(frame)},
      projection_{projection},
      low_{area.low} {
  const double extent = std::max(area.width_m(), area.height_m());
  const double step = std::max(finest_step_m, extent / most_cells_a_side);
  inverse_step_ = 1.0 / step;
  nx_ = static_cast<std::size_t>(std::ceil(area.width_m() / step)) + 2;
  ny_ = static_cast<std::size_t>(std::ceil(area.height_m() / step)) + 2;
  nodes_.reserve(nx_ * ny_);
  for (std::size_t iy = 0; iy < ny_ && !stop.stop_requested(); ++iy) {
    for (std::size_t ix = 0; ix < nx_; ++ix) {
      nodes_.push_back(
          exact({low_.x_m + step * static_cast<double>(ix), low_.y_m + step * static_cast<double>(iy)}));
    }
  }
  nodes_.resize(nx_ * ny_);
  if (stop.stop_requested()) return;
  if (is_geographic_) {
    std::vector<double> longitudes_deg;
    longitudes_deg.reserve(nodes_.size());
    for (const geo::GridPoint& node : nodes_) longitudes_deg.push_back(node.x);
    has_jump_ = jumps_among(longitudes_deg);
  } else if (const auto cut_deg = frame_.cut_deg()) {
    std::vector<double> from_cut_deg;
    from_cut_deg.reserve(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const geo::LonLat place = projection_.to_lon_lat(
          {low_.x_m + step * static_cast<double>(i % nx_), low_.y_m + step * static_cast<double>(i / nx_)});
      const double east_deg = geo::longitude_difference(*cut_deg, place.lon_deg);
      from_cut_deg.push_back(east_deg < 0.0 ? east_deg + 360.0 : east_deg);
    }
    has_jump_ = jumps_among(from_cut_deg);
  }
}

bool GridLookup::jumps_among(const std::vector<double>& longitudes_deg) const {
  for (std::size_t i = 1; i < longitudes_deg.size(); ++i) {
    const double here = longitudes_deg[i];
    if ((i % nx_ != 0 && std::abs(here - longitudes_deg[i - 1]) > jump_deg) ||
        (i >= nx_ && std::abs(here - longitudes_deg[i - nx_]) > jump_deg))
      return true;
  }
  return false;
}

geo::GridPoint GridLookup::exact(geo::PlanePoint point) const {
  const geo::LonLat place = projection_.to_lon_lat(point);
  if (is_geographic_) {
    const double origin = projection_.origin().lon_deg;
    return {origin + geo::longitude_difference(origin, place.lon_deg), place.lat_deg};
  }
  return frame_.to_grid(place);
}

GridLookup::Cell GridLookup::cell(geo::PlanePoint point) const {
  const double x = (point.x_m - low_.x_m) * inverse_step_;
  const double y = (point.y_m - low_.y_m) * inverse_step_;
  const auto ix = std::min(static_cast<std::size_t>(std::max(0.0, x)), nx_ - 2);
  const auto iy = std::min(static_cast<std::size_t>(std::max(0.0, y)), ny_ - 2);
  return {nodes_.data() + iy * nx_ + ix, x - static_cast<double>(ix), y - static_cast<double>(iy)};
}

geo::GridPoint GridLookup::coordinates(geo::PlanePoint point) const {
  const auto [corner, fx, fy] = cell(point);
  const geo::GridPoint& sw = corner[0];
  const geo::GridPoint& se = corner[1];
  const geo::GridPoint& nw = corner[nx_];
  const geo::GridPoint& ne = corner[nx_ + 1];
  if (has_jump_) {
    const auto [least, most] = std::minmax({sw.x, se.x, nw.x, ne.x});
    if (!is_geographic_ || most - least > jump_deg) return exact(point);
  }
  const double south_x = sw.x + fx * (se.x - sw.x);
  const double south_y = sw.y + fx * (se.y - sw.y);
  return {south_x + fy * (nw.x + fx * (ne.x - nw.x) - south_x),
          south_y + fy * (nw.y + fx * (ne.y - nw.y) - south_y)};
}

GridLookup::Surroundings GridLookup::around(geo::PlanePoint point) const {
  const auto [corner, fx, fy] = cell(point);
  const geo::GridPoint& sw = corner[0];
  const geo::GridPoint& se = corner[1];
  const geo::GridPoint& nw = corner[nx_];
  const geo::GridPoint& ne = corner[nx_ + 1];
  const geo::GridPoint south{se.x - sw.x, se.y - sw.y};
  const geo::GridPoint west{nw.x - sw.x, nw.y - sw.y};
  const geo::GridPoint twist{ne.x - nw.x - south.x, ne.y - nw.y - south.y};
  return {{sw.x + fx * south.x + fy * (west.x + fx * twist.x),
           sw.y + fx * south.y + fy * (west.y + fx * twist.y)},
          {(south.x + fy * twist.x) * inverse_step_, (south.y + fy * twist.y) * inverse_step_},
          {(west.x + fx * twist.x) * inverse_step_, (west.y + fx * twist.y) * inverse_step_}};
}

geo::GridPoint GridLookup::steepest() const {
  geo::GridPoint along_x{};
  geo::GridPoint along_y{};
  const auto worsen = [](geo::GridPoint& most, const geo::GridPoint& a, const geo::GridPoint& b) {
    most = {std::max(most.x, std::abs(b.x - a.x)), std::max(most.y, std::abs(b.y - a.y))};
  };
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if ((i + 1) % nx_ != 0) worsen(along_x, nodes_[i], nodes_[i + 1]);
    if (i + nx_ < nodes_.size()) worsen(along_y, nodes_[i], nodes_[i + nx_]);
  }
  return {std::hypot(along_x.x, along_y.x) * inverse_step_, std::hypot(along_x.y, along_y.y) * inverse_step_};
}

geo::GridPoint GridLookup::bend() const {
  geo::GridPoint straight{};
  geo::GridPoint mixed{};
  const auto worsen = [](geo::GridPoint& bend, double x, double y) {
    bend = {std::max(bend.x, std::abs(x)), std::max(bend.y, std::abs(y))};
  };
  for (std::size_t iy = 0; iy < ny_; ++iy) {
    for (std::size_t ix = 0; ix < nx_; ++ix) {
      const geo::GridPoint* at = nodes_.data() + iy * nx_ + ix;
      if (ix + 2 < nx_)
        worsen(straight, at[0].x - 2.0 * at[1].x + at[2].x, at[0].y - 2.0 * at[1].y + at[2].y);
      if (iy + 2 < ny_) {
        worsen(straight, at[0].x - 2.0 * at[nx_].x + at[2 * nx_].x,
               at[0].y - 2.0 * at[nx_].y + at[2 * nx_].y);
      }
      if (ix + 1 < nx_ && iy + 1 < ny_) {
        worsen(mixed, at[0].x - at[1].x - at[nx_].x + at[nx_ + 1].x,
               at[0].y - at[1].y - at[nx_].y + at[nx_ + 1].y);
      }
    }
  }
  // Second derivative along a unit vector (p, q): p^2 f_xx + 2 p q f_xy + q^2 f_yy, with 2 p q <= 1.
  const double per_square_metre = inverse_step_ * inverse_step_;
  return {per_square_metre * (straight.x + mixed.x), per_square_metre * (straight.y + mixed.y)};
}

}  // namespace floeplan::planning::plane
