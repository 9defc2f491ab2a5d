#include "engine/planning/cost/overhead.hpp"

namespace floeplan::planning::cost {

ice::UnderIce::Leave Overhead::leave(std::optional<ice::IceWatch>& watch, geo::PlanePoint point,
                                     core::Seconds time) const {
  ice::UnderIce::Leave leave = watch ? watch->look(point, time) : ice::UnderIce::Leave{true, true};
  leave.to_surface = leave.to_surface && !icebergs_->least_upper_turn(point, time);
  return leave;
}

core::Metres Overhead::look() const {
  constexpr core::Metres without_ice{250.0};  // a quarter of the smallest disc around an iceberg
  return ice_ ? ice_->step() : without_ice;
}

}  // namespace floeplan::planning::cost
