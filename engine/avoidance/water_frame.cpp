#include "engine/avoidance/water_frame.hpp"

#include <cmath>

namespace floeplan::avoidance {

void WaterFrame::step(const OwnState& own) {
  if (last_) {
    const double way_m = last_->through_water.value * (own.time - last_->time).count();
    own_.x_m += way_m * std::sin(last_->attitude.heading.value);
    own_.y_m += way_m * std::cos(last_->attitude.heading.value);
  }
  shift_ = {own.place.x_m - own_.x_m, own.place.y_m - own_.y_m};
  last_ = own;
}

}  // namespace floeplan::avoidance
