#include "engine/planning/ice/under_ice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/motion/drive_looks.hpp"

namespace floeplan::planning::ice {
namespace {

/// Whether there is no ice that dives must turn below: neither known now nor when last known.
bool is_free(const IceAbove& ice) { return ice.may_surface || (!ice.known && !(ice.draft_m > 0.0)); }

}  // namespace

UnderIce::UnderIce(const ocean::Environment& environment, const PlanRequest& request,
                   const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
                   std::shared_ptr<const obstacles::BedCells> bed, const std::stop_token& stop)
    : rules_{request.under_ice},
      cover_{environment, request.under_ice, projection, area, request.depart, stop},
      bed_{cover_.has_dense_ice() ? std::move(bed) : nullptr},
      needed_below_m_{request.vehicle.least_water_below_turn().value},
      dive_room_m_{needed_below_m_ - request.vehicle.altimeter_margin.value},
      dive_depth_m_{request.vehicle.dive_depth.value},
      step_m_{std::min(cell.value, 0.25 * cover_.spacing().value)} {
  if (!stop.stop_requested()) tight_ = tight_cells();
}

std::optional<obstacles::MarkedCells> UnderIce::tight_cells() const {
  const core::Metres deepest_turn = cover_.deepest_draft() + rules_.margin_below_ice;
  if (!bed_ || deepest_turn.value + dive_room_m_ > dive_depth_m_) return std::nullopt;
  const core::Metres needed = deepest_turn + core::Metres{needed_below_m_};
  const plane::PlaneRaster& raster = bed_->raster();
  const double to_corner_m = std::numbers::sqrt2 * 0.5 * raster.cell_m();
  std::vector<bool> tight(raster.size(), false);
  for (std::size_t cell = 0; cell < tight.size(); ++cell) {
    tight[cell] = !(bed_->least_depth(cell) >= needed) &&
                  cover_.least_way_to_dense_ice(raster.centre(cell)).value <= to_corner_m;
  }
  return obstacles::MarkedCells{raster, tight};
}

core::Metres UnderIce::turn_below(const IceAbove& ice) const {
  return is_free(ice) ? core::Metres{0.0} : core::Metres{ice.draft_m} + rules_.margin_below_ice;
}

bool UnderIce::has_room_below(core::Metres turn, geo::PlanePoint a, geo::PlanePoint b) const {
  if (turn.value == 0.0) return true;
  if (turn.value + dive_room_m_ > dive_depth_m_) return false;
  return !bed_ || bed_->is_deep_along(a, b, turn + core::Metres{needed_below_m_});
}

core::Metres UnderIce::least_upper_turn(geo::PlanePoint point, core::Seconds time) const {
  return turn_below(cover_.above(point, time));
}

bool UnderIce::may_transit(geo::PlanePoint point, core::Seconds time) const {
  return has_room_below(least_upper_turn(point, time), point, point);
}

bool UnderIce::may_transit_along(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const {
  IceWatch watch{*this, motion::place_along(edge, piece.way0_m), core::Seconds{piece.t0_s}};
  bool open = true;
  motion::look_along(edge, piece, step(), [&](geo::PlanePoint point, core::Seconds time) {
    open = watch.look(point, time).to_transit;
    return open;
  });
  return open;
}

UnderIce::Leave IceWatch::look(geo::PlanePoint point, core::Seconds time) {
  const IceAbove ice = ice_.above(point, time);
  const core::Metres turn = ice_.turn_below(ice);
  const UnderIce::Leave leave{.to_surface = ice.may_surface,
                              .to_transit = ice_.has_room_below(std::max(last_turn_, turn), last_, point)};
  last_ = point;
  last_turn_ = turn;
  return leave;
}

}  // namespace floeplan::planning::ice
