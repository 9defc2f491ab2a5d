#include "engine/simulation/vehicle/true_state.hpp"

#include <cmath>

namespace floeplan::simulation {

BodyAxes::BodyAxes(const Attitude& attitude) {
  const double ch = std::cos(attitude.heading_rad);
  const double sh = std::sin(attitude.heading_rad);
  const double cp = std::cos(attitude.pitch_rad);
  const double sp = std::sin(attitude.pitch_rad);
  const double cr = std::cos(attitude.roll_rad);
  const double sr = std::sin(attitude.roll_rad);
  const Vector level_starboard{ch, -sh, 0.0};
  const Vector pitched_down{sh * sp, ch * sp, cp};
  forward_ = {sh * cp, ch * cp, -sp};
  starboard_ = cr * level_starboard + sr * pitched_down;
  down_ = cr * pitched_down - sr * level_starboard;
}

}  // namespace floeplan::simulation
