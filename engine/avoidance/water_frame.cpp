#include "engine/avoidance/water_frame.hpp"

#include <cmath>

namespace floeplan::avoidance {

void WaterFrame::step(const OwnState& own) {
  if (last_) {
    const double speed_m_s = last_->at_surface ? 0.0 : last_->through_water.value;
    const double way_m = speed_m_s * (own.time - last_->time).count();
    own_.x_m += way_m * std::sin(last_->attitude.heading.value);
    own_.y_m += way_m * std::cos(last_->attitude.heading.value);
  }
  shift_ = {own.place.x_m - own_.x_m, own.place.y_m - own_.y_m};
  last_ = own;
}

}  // namespace floeplan::avoidance
