#include "engine/ocean/grids/horizontal_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geo/geodesic.hpp"

namespace floeplan::ocean {
namespace {

/// Whether the gap between the last and the first geographic longitude is at most a step (with room for
/// rounding).
bool goes_all_the_way_round(const geo::GridFrame& frame, const Axis& x) {
  if (!std::holds_alternative<geo::GeographicFrame>(frame) || x.size() < 3) return false;
  const double gap = 360.0 - (x.back() - x.front());
  return gap > 0.0 && gap <= 1.01 * x.mean_step();
}

}  // namespace

HorizontalGrid::HorizontalGrid(const geo::GridFrame& frame, Axis x, Axis y)
    : projection_{frame}, x_{std::move(x)}, y_{std::move(y)}, wraps_{goes_all_the_way_round(frame, x_)} {}

geo::LonLat HorizontalGrid::place(std::size_t ix, std::size_t iy) const {
  return projection_.to_lon_lat({x_[ix], y_[iy]});
}

std::optional<GridPosition> HorizontalGrid::locate(geo::LonLat place) const {
  return locate_point(projection_.to_grid(place));
}

std::optional<GridPosition> HorizontalGrid::locate_point(geo::GridPoint point) const {
  const auto y = y_.locate(point.y);
  if (!y) return std::nullopt;
  const auto x = locate_column(point.x);
  if (!x) return std::nullopt;
  return GridPosition{*x, *y};
}

std::optional<AxisPosition> HorizontalGrid::locate_column(double x) const {
  if (std::holds_alternative<geo::GeographicFrame>(frame())) {
    // Longitudes count eastwards from the first node. A point west of it by a rounding error is that node.
    const double turns = std::floor((x - x_.front()) / 360.0 + 1e-9);
    x = std::max(x - 360.0 * turns, x_.front());
  }

  const auto column = x_.locate(x);
  if (column || !wraps_) return column;
  const double gap = x_.front() + 360.0 - x_.back();
  return AxisPosition{x_.size() - 1, 0, std::clamp((x - x_.back()) / gap, 0.0, 1.0)};
}

geo::BoundingBox HorizontalGrid::bounds() const {
  if (std::holds_alternative<geo::GeographicFrame>(frame())) {
    if (wraps_ || x_.back() - x_.front() >= 360.0) return {-180.0, y_.front(), 180.0, y_.back()};
    return {geo::wrap_longitude(x_.front()), y_.front(), geo::wrap_longitude(x_.back()), y_.back()};
  }

  std::vector<geo::LonLat> rim;
  for (std::size_t ix = 0; ix < x_.size(); ++ix) {
    rim.push_back(place(ix, 0));
    rim.push_back(place(ix, y_.size() - 1));
  }
  for (std::size_t iy = 0; iy < y_.size(); ++iy) {
    rim.push_back(place(0, iy));
    rim.push_back(place(x_.size() - 1, iy));
  }
  // A node may be beside itself by the rounding of the projection.
  constexpr core::Metres rounding{1e-5};
  geo::BoundingBox box = geo::grown(geo::bounding_box(std::span<const geo::LonLat>{rim}), rounding);
  for (const double pole_deg : {-90.0, 90.0}) {
    if (!locate({0.0, pole_deg})) continue;
    (pole_deg > 0.0 ? box.north_deg : box.south_deg) = pole_deg;
    box.west_deg = -180.0;
    box.east_deg = 180.0;
  }
  return box;
}

core::Metres HorizontalGrid::spacing() const {
  const std::size_t ix = (x_.size() - 1) / 2;
  const std::size_t iy = (y_.size() - 1) / 2;
  const geo::LonLat centre = place(ix, iy);
  core::Metres least{INFINITY};
  if (ix + 1 < x_.size()) least = std::min(least, geo::geodesic_between(centre, place(ix + 1, iy)).length);
  if (iy + 1 < y_.size()) least = std::min(least, geo::geodesic_between(centre, place(ix, iy + 1)).length);
  return std::isfinite(least.value) ? least : core::Metres{0.0};
}

}  // namespace floeplan::ocean
