#pragma once

#include <optional>

#include "engine/avoidance/sensed.hpp"
#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::avoidance {

/// The frame that drifts with the water, reckoned from compass and speed alone. In it the vehicle moves where its nose
/// points, a berg moves by its drift through the water, and what is fixed to the ground moves against the current. No
/// error of the current, and no position fix that corrects the place, ever moves an obstacle against the vehicle.
/// Surface  a vehicle that drifts there is taken to drift with the water
/// Frame    metres east and north of the place where the reckoning began
class WaterFrame {
 public:
  /// Times never go back.
  void step(const OwnState& own);

  [[nodiscard]] geo::PlanePoint own() const { return own_; }
  /// Where a place of the local plane lies now.
  [[nodiscard]] geo::PlanePoint from_local(geo::PlanePoint place) const {
    return {place.x_m - shift_.x_m, place.y_m - shift_.y_m};
  }
  [[nodiscard]] geo::PlanePoint to_local(geo::PlanePoint place) const {
    return {place.x_m + shift_.x_m, place.y_m + shift_.y_m};
  }

 private:
  geo::PlanePoint own_{};
  geo::PlanePoint shift_{};  // of the local plane's place of something that is seen here at (0, 0)
  std::optional<OwnState> last_{};
};

}  // namespace floeplan::avoidance
