#pragma once

#include <optional>

#include "engine/avoidance/sensed.hpp"
#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::avoidance {

/// The frame that drifts with the water, computed from compass and speed alone. In it the vehicle moves where
/// its nose points, a berg moves by its drift through the water, and places on the ground move against the
/// current. So neither an error of the current nor a fix that corrects the place moves an obstacle relative
/// to the vehicle.
/// Surface  a vehicle that drifts at the surface is assumed to drift with the water
/// Frame    metres east and north of the place where the computation began
class WaterFrame {
 public:
  /// Times never go back.
  void step(const OwnState& own);

  [[nodiscard]] geo::PlanePoint own() const { return own_; }
  /// Present position of a place of the local plane in this frame.
  [[nodiscard]] geo::PlanePoint from_local(geo::PlanePoint place) const {
    return {place.x_m - shift_.x_m, place.y_m - shift_.y_m};
  }
  [[nodiscard]] geo::PlanePoint to_local(geo::PlanePoint place) const {
    return {place.x_m + shift_.x_m, place.y_m + shift_.y_m};
  }

 private:
  geo::PlanePoint own_{};
  geo::PlanePoint shift_{};  // place in the local plane of this frame's origin
  std::optional<OwnState> last_{};
};

}  // namespace floeplan::avoidance
