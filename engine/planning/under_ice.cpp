#include "engine/planning/under_ice.hpp"

#include <algorithm>
#include <cmath>

#include "engine/motion/drive_looks.hpp"

namespace floeplan::planning {
namespace {

/// Whether no ice is known above that the vehicle would have to keep below, or was known last.
bool is_free(const IceAbove& ice) { return ice.may_surface || (!ice.known && !(ice.draft_m > 0.0)); }

}  // namespace

UnderIce::UnderIce(const ocean::Environment& environment, const PlanRequest& request,
                   const geo::LocalProjection& projection, const PlaneBox& area, core::Metres step,
                   const std::stop_token& stop)
    : rules_{request.under_ice},
      cover_{environment, request.under_ice, projection, area, request.depart, stop},
      needed_below_m_{request.vehicle.least_water_below_turn().value},
      dive_room_m_{needed_below_m_ - request.vehicle.altimeter_margin.value},
      dive_depth_m_{request.vehicle.dive_depth.value},
      step_m_{std::min(step.value, 0.25 * cover_.spacing().value)} {
  if (environment.bathymetry) bed_.emplace(environment.bathymetry, projection, area, stop);
}

bool UnderIce::has_room_below(geo::PlanePoint point, const IceAbove& ice) const {
  if (is_free(ice)) return true;
  const double upper_turn_m = ice.draft_m + rules_.margin_below_ice.value;
  if (upper_turn_m + dive_room_m_ > dive_depth_m_) return false;
  if (!bed_) return true;
  const auto depth = bed_->depth(point);
  return depth && depth->value >= upper_turn_m + needed_below_m_;
}

core::Metres UnderIce::least_upper_turn(geo::PlanePoint point, core::Seconds time) const {
  const IceAbove ice = cover_.above(point, time);
  if (is_free(ice)) return core::Metres{0.0};
  return core::Metres{ice.draft_m} + rules_.margin_below_ice;
}

bool UnderIce::may_transit(geo::PlanePoint point, core::Seconds time) const {
  return has_room_below(point, cover_.above(point, time));
}

UnderIce::Leave UnderIce::leave(geo::PlanePoint point, core::Seconds time) const {
  const IceAbove ice = cover_.above(point, time);
  return {.to_surface = ice.may_surface, .to_transit = has_room_below(point, ice)};
}

bool UnderIce::may_transit_along(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const {
  if (!may_be_dense_along(edge.from, edge.to)) return true;
  bool open = true;
  motion::look_along(edge, piece, step(), [&](geo::PlanePoint point, core::Seconds time) {
    open = may_transit(point, time);
    return open;
  });
  return open;
}

}  // namespace floeplan::planning
