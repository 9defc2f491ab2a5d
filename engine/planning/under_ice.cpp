#include "engine/planning/under_ice.hpp"

#include <algorithm>
#include <cmath>

#include "engine/motion/drive_looks.hpp"

namespace floeplan::planning {

UnderIce::UnderIce(const ocean::Environment& environment, const PlanRequest& request,
                   const geo::LocalProjection& projection, const PlaneBox& area, core::Metres step,
                   const std::stop_token& stop)
    : rules_{request.under_ice},
      cover_{*environment.ice, request.under_ice, projection, area, request.depart, stop},
      bathymetry_{environment.bathymetry},
      needed_below_m_{request.vehicle.minimum_working_depth.value},
      dive_room_m_{std::max(
          0.0, request.vehicle.minimum_working_depth.value - request.vehicle.altimeter_margin.value)},
      dive_depth_m_{request.vehicle.dive_depth.value},
      step_m_{std::min(step.value, 0.25 * cover_.spacing().value)} {
  if (bathymetry_) bed_grid_.emplace(bathymetry_->grid(), projection, area, stop);
}

std::optional<double> UnderIce::bed_m(geo::PlanePoint point) const {
  const auto cell = bed_grid_->corner(point);
  if (!cell) return std::nullopt;
  const std::size_t nx = bed_grid_->nx();
  const std::size_t columns = bathymetry_->grid().x().size();
  const auto node = [&](std::size_t i) {
    return static_cast<double>(
        bathymetry_->depth_m()[bed_grid_->row(i / nx) * columns + bed_grid_->column(i % nx)]);
  };
  const std::size_t sw = cell->first;
  const double south = node(sw) + cell->fx * (node(sw + 1) - node(sw));
  const double north = node(sw + nx) + cell->fx * (node(sw + nx + 1) - node(sw + nx));
  const double depth_m = south + cell->fy * (north - south);
  if (std::isnan(depth_m)) return std::nullopt;
  return depth_m;
}

bool UnderIce::has_room_below(geo::PlanePoint point, const IceAbove& ice) const {
  if (ice.may_surface || !ice.known) return true;
  const double upper_turn_m = ice.draft_m + rules_.margin_below_ice.value;
  if (upper_turn_m + dive_room_m_ > dive_depth_m_) return false;
  if (!bathymetry_) return true;
  const auto depth_m = bed_m(point);
  return depth_m && *depth_m >= upper_turn_m + needed_below_m_;
}

core::Metres UnderIce::least_upper_turn(geo::PlanePoint point, core::Seconds time) const {
  const IceAbove ice = cover_.above(point, time);
  if (ice.may_surface || !ice.known) return core::Metres{0.0};
  return core::Metres{ice.draft_m} + rules_.margin_below_ice;
}

bool UnderIce::may_transit(geo::PlanePoint point, core::Seconds time) const {
  return has_room_below(point, cover_.above(point, time));
}

bool UnderIce::may_transit_along(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const {
  bool open = true;
  motion::look_along(edge, piece, step(), [&](geo::PlanePoint point, core::Seconds time) {
    open = may_transit(point, time);
    return open;
  });
  return open;
}

std::optional<motion::EdgeClosed> IceWatch::operator()(const motion::EdgePiece& piece) {
  std::optional<motion::EdgeClosed> closed;
  const auto longest = ice_.longest_without_surfacing();
  double now_s = piece.t0_s;
  motion::look_along(edge_, piece, ice_.step(), [&](geo::PlanePoint point, core::Seconds time) {
    const bool open = ice_.may_surface(point, time);
    const bool open_all_along = open && since_s_ == 0.0;
    if (!open_all_along) since_s_ += time.count() - now_s;
    if (!ice_.may_transit(point, time)) {
      closed = motion::EdgeClosed::under_ice;
    } else if (longest && since_s_ > longest->count()) {
      closed = motion::EdgeClosed::no_surfacing;
    }
    if (open) since_s_ = 0.0;
    now_s = time.count();
    return !closed;
  });
  return closed;
}

}  // namespace floeplan::planning
