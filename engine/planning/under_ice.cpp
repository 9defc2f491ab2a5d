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
      needed_below_m_{request.vehicle.minimum_working_depth.value},
      dive_room_m_{std::max(
          0.0, request.vehicle.minimum_working_depth.value - request.vehicle.altimeter_margin.value)},
      dive_depth_m_{request.vehicle.dive_depth.value},
      step_m_{std::min(step.value, 0.25 * cover_.spacing().value)} {
  if (environment.bathymetry) bed_.emplace(environment.bathymetry, projection, area, stop);
}

bool UnderIce::has_room_below(geo::PlanePoint point, const IceAbove& ice) const {
  if (ice.may_surface || !ice.known) return true;
  const double upper_turn_m = ice.draft_m + rules_.margin_below_ice.value;
  if (upper_turn_m + dive_room_m_ > dive_depth_m_) return false;
  if (!bed_) return true;
  const auto depth = bed_->depth(point);
  return depth && depth->value >= upper_turn_m + needed_below_m_;
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
