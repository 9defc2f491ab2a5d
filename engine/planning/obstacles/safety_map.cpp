#include "engine/planning/obstacles/safety_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/geo/coarse_outline.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/obstacles/least_depth_rows.hpp"
#include "engine/planning/obstacles/stay_in_cells.hpp"
#include "engine/planning/plane/lon_lat_box.hpp"
#include "engine/planning/plane/plane_raster.hpp"
#include "engine/planning/plane/polygon_cells.hpp"

namespace floeplan::planning::obstacles {
namespace {

CellState state_of(std::optional<motion::EdgeClosed> verdict) {
  if (!verdict) return CellState::open;
  if (*verdict == motion::EdgeClosed::on_land) return CellState::on_land;
  return *verdict == motion::EdgeClosed::too_shallow ? CellState::too_shallow : CellState::outside_data;
}

/// Why a place with this depth is closed to a vehicle that needs `least_depth`; empty if it is open. An unknown
/// depth (empty) is closed.
std::optional<motion::EdgeClosed> judge_depth(std::optional<core::Metres> depth, core::Metres least_depth) {
  if (!depth) return motion::EdgeClosed::outside_data;
  if (depth->value <= 0.0) return motion::EdgeClosed::on_land;
  if (*depth < least_depth) return motion::EdgeClosed::too_shallow;
  return std::nullopt;
}

CellState state_at(float least_m, core::Metres least_depth) {
  const auto known = std::isnan(least_m) ? std::nullopt : std::optional{core::Metres{least_m}};
  return state_of(judge_depth(known, least_depth));
}

/// The state of each cell by the least depth in it (`LeastDepthRows`).
/// Stops    early once `stop` is requested; the states are then incomplete
std::vector<CellState> judge_depths(const plane::PlaneRaster& raster, const ocean::Bathymetry& bathymetry,
                                    core::Metres least_depth, const geo::LocalProjection& projection,
                                    const std::stop_token& stop) {
  std::vector<CellState> cells;
  cells.reserve(raster.size());
  LeastDepthRows rows{raster, bathymetry, least_depth, projection, stop};
  for (std::int64_t row = 0; row < raster.ny() && !stop.stop_requested(); ++row) {
    std::ranges::transform(rows.next(), std::back_inserter(cells),
                           [&](float least_m) { return state_at(least_m, least_depth); });
  }
  cells.resize(raster.size(), CellState::open);
  return cells;
}

/// The same by the least depths of a sea bed on the raster of the map.
std::vector<CellState> judge_depths(const BedCells& bed, core::Metres least_depth) {
  std::vector<CellState> cells;
  cells.reserve(bed.raster().size());
  for (std::size_t cell = 0; cell < bed.raster().size(); ++cell)
    cells.push_back(state_at(static_cast<float>(bed.least_depth(cell).value), least_depth));
  return cells;
}

constexpr double look_up_step_m = 25.0;  // a tenth of the finest bathymetry in use

std::optional<motion::EdgeClosed> reason_of(CellState state) {
  switch (state) {
    case CellState::open: return std::nullopt;
    case CellState::too_shallow: return motion::EdgeClosed::too_shallow;
    case CellState::on_land: return motion::EdgeClosed::on_land;
    case CellState::outside_data: return motion::EdgeClosed::outside_data;
    case CellState::in_zone: return motion::EdgeClosed::in_zone;
  }
  throw std::logic_error{"CellState without a reason"};
}

/// Box around the raster's cells, with room for the bend of its outline in longitude and latitude.
geo::BoundingBox box_about(const plane::PlaneRaster& raster, const geo::LocalProjection& projection) {
  const plane::PlaneBox& area = raster.area();
  const double margin_m = 2.0 * raster.cell_m() + 1000.0 + 0.01 * std::max(area.width_m(), area.height_m());
  return plane::lon_lat_box(area.grown(margin_m), projection);
}

}  // namespace

SafetyMap::SafetyMap(const ocean::Environment& environment, core::Metres least_depth, StandingZones zones,
                     const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
                     const BedCells* bed, const std::stop_token& stop)
    : environment_{&environment},
      least_depth_{least_depth},
      zones_{std::move(zones)},
      raster_{area, cell},
      detailed_{box_about(raster_, projection)},
      cells_(raster_.size(), CellState::open) {
  if (bed != nullptr) {
    cells_ = judge_depths(*bed, least_depth);
  } else if (environment.bathymetry) {
    cells_ = judge_depths(raster_, *environment.bathymetry, least_depth, projection, stop);
  }
  for (const geo::Polygon& polygon : environment.land) {
    if (stop.stop_requested()) return;
    land_.push_back(geo::coarse_beyond(detailed_, polygon));
    close_cells(land_.back(), CellState::on_land, projection);
  }
  close_zones(projection, stop);
  measure_clearance(stop);
}

std::size_t SafetyMap::bytes() const {
  std::size_t bytes = cells_.size() * sizeof(CellState) + clearance_.size();
  for (const geo::Polygon& polygon : land_) bytes += polygon.bytes();
  return bytes;
}

void SafetyMap::close_cells(const geo::Polygon& polygon, CellState state,
                            const geo::LocalProjection& projection) {
  const auto close = [&](std::size_t cell) { cells_[cell] = state; };
  plane::visit_cells(polygon, raster_, projection, close, close);
}

void SafetyMap::close_zones(const geo::LocalProjection& projection, const std::stop_token& stop) {
  for (const geo::Polygon& area : zones_.no_go) {
    if (stop.stop_requested()) return;
    close_cells(area, CellState::in_zone, projection);
  }
  if (!zones_.confined) return;
  const std::vector<bool> allowed = cells_to_stay_in(zones_.stay_in, raster_, projection, stop);
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    if (!allowed[cell] && cells_[cell] == CellState::open) cells_[cell] = CellState::in_zone;
  }
}

void SafetyMap::measure_clearance(const std::stop_token& stop) {
  // Distance in cells, by two sweeps over the eight neighbours; all beyond the raster counts as closed.
  constexpr int most = 255;
  clearance_.assign(cells_.size(), 0);
  const auto at = [&](std::int64_t ix, std::int64_t iy) -> int {
    if (ix < 0 || ix >= raster_.nx() || iy < 0 || iy >= raster_.ny()) return 0;
    return clearance_[static_cast<std::size_t>(iy * raster_.nx() + ix)];
  };
  for (std::int64_t iy = 0; iy < raster_.ny() && !stop.stop_requested(); ++iy) {
    for (std::int64_t ix = 0; ix < raster_.nx(); ++ix) {
      const auto i = static_cast<std::size_t>(iy * raster_.nx() + ix);
      if (cells_[i] != CellState::open) continue;
      const int least = std::min({at(ix - 1, iy), at(ix - 1, iy - 1), at(ix, iy - 1), at(ix + 1, iy - 1)});
      clearance_[i] = static_cast<std::uint8_t>(std::min(least + 1, most));
    }
  }
  for (std::int64_t iy = raster_.ny() - 1; iy >= 0 && !stop.stop_requested(); --iy) {
    for (std::int64_t ix = raster_.nx() - 1; ix >= 0; --ix) {
      const auto i = static_cast<std::size_t>(iy * raster_.nx() + ix);
      if (cells_[i] != CellState::open) continue;
      const int least = std::min({at(ix + 1, iy), at(ix + 1, iy + 1), at(ix, iy + 1), at(ix - 1, iy + 1)});
      clearance_[i] = static_cast<std::uint8_t>(std::min({static_cast<int>(clearance_[i]), least + 1, most}));
    }
  }
}

std::optional<motion::EdgeClosed> SafetyMap::closed_between(geo::PlanePoint a, geo::PlanePoint b) const {
  const auto start = raster_.index(a);
  if (!start || !raster_.index(b)) return motion::EdgeClosed::outside_data;
  const double reach_m = std::max(std::abs(b.x_m - a.x_m), std::abs(b.y_m - a.y_m));
  // With a clearance of n there are at least n - 1 whole open cells around the cell in which the line starts.
  if (reach_m <= (clearance_[*start] - 1) * raster_.cell_m()) return std::nullopt;
  const auto middle = raster_.index({0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m)});
  if (middle && 0.5 * reach_m <= (clearance_[*middle] - 1) * raster_.cell_m()) return std::nullopt;

  std::optional<motion::EdgeClosed> closed;
  raster_.for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
    closed = reason_of(cells_[raster_.index(ix, iy)]);
    return !closed;
  });
  return closed;
}

bool SafetyMap::open_about(geo::PlanePoint point, core::Metres reach) const {
  const auto cell = raster_.index(point);
  // With a clearance of n there are at least n - 1 whole open cells around the point's cell.
  return cell && reach.value <= (clearance_[*cell] - 1) * raster_.cell_m();
}

bool SafetyMap::is_on_land(geo::LonLat place) const {
  const auto& land = geo::contains(detailed_, place) ? land_ : environment_->land;
  return std::ranges::any_of(land,
                             [&](const geo::Polygon& polygon) { return geo::contains(polygon, place); });
}

std::optional<motion::EdgeClosed> SafetyMap::closed_at(geo::LonLat place) const {
  const auto holds = [&](const geo::Polygon& polygon) { return geo::contains(polygon, place); };
  if (is_on_land(place)) return motion::EdgeClosed::on_land;
  if (std::ranges::any_of(zones_.no_go, holds)) return motion::EdgeClosed::in_zone;
  if (zones_.confined && std::ranges::none_of(zones_.stay_in, holds)) return motion::EdgeClosed::in_zone;
  if (!environment_->bathymetry) return std::nullopt;
  return judge_depth(environment_->bathymetry->shoalest(place), least_depth_);
}

std::vector<std::size_t> SafetyMap::closed_cells_between(geo::PlanePoint a, geo::PlanePoint b) const {
  std::vector<std::size_t> closed;
  raster_.for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
    if (raster_.holds(ix, iy) && cells_[raster_.index(ix, iy)] != CellState::open)
      closed.push_back(raster_.index(ix, iy));
    return true;
  });
  std::ranges::sort(closed);
  return closed;
}

bool SafetyMap::closed_within(const std::vector<std::size_t>& cells, geo::PlanePoint a, geo::PlanePoint b,
                              const geo::LocalProjection& projection) const {
  const int pieces = std::max(1, static_cast<int>(std::ceil(geo::distance_m(a, b) / look_up_step_m)));
  for (int piece = 0; piece <= pieces; ++piece) {
    const double share = static_cast<double>(piece) / pieces;
    const geo::PlanePoint point{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
    const auto cell = raster_.index(point);
    if (cell && std::ranges::binary_search(cells, *cell) && closed_at(projection.to_lon_lat(point)))
      return true;
  }
  return false;
}

void SafetyMap::open_along(const std::vector<std::vector<geo::PlanePoint>>& routes,
                           const geo::LocalProjection& projection) {
  std::vector<std::size_t> cautious;
  std::vector<std::size_t> kept_closed;
  for (const std::vector<geo::PlanePoint>& route : routes) {
    for (std::size_t i = 1; i < route.size(); ++i) {
      const auto closed = closed_cells_between(route[i - 1], route[i]);
      if (closed.empty()) continue;
      auto& cells = closed_within(closed, route[i - 1], route[i], projection) ? kept_closed : cautious;
      cells.insert(cells.end(), closed.begin(), closed.end());
    }
  }
  std::ranges::sort(kept_closed);
  for (const std::size_t cell : cautious) {
    if (std::ranges::binary_search(kept_closed, cell)) continue;
    cells_[cell] = CellState::open;
    clearance_[cell] = 1;
  }
}

void SafetyMap::open_around(geo::PlanePoint point) {
  const auto i = raster_.index(point);
  if (!i || cells_[*i] == CellState::open) return;
  cells_[*i] = CellState::open;
  clearance_[*i] = 1;
}

}  // namespace floeplan::planning::obstacles
