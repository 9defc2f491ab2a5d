#include "engine/motion/speed_over_ground.hpp"

#include <cmath>

namespace floeplan::motion {

tl::expected<core::MetresPerSecond, EdgeClosed> speed_over_ground(core::MetresPerSecond through_water,
                                                                  geo::VelocityEn current,
                                                                  geo::Bearing course) {
  const double along = current.east.value * course.east() + current.north.value * course.north();
  const double across = current.east.value * course.north() - current.north.value * course.east();

  const double margin = through_water.value * through_water.value - across * across;
  if (margin <= 0.0) return tl::unexpected(EdgeClosed::current_too_strong);

  const double over_ground = along + std::sqrt(margin);
  if (over_ground <= 0.0) return tl::unexpected(EdgeClosed::current_too_strong);
  return core::MetresPerSecond{over_ground};
}

}  // namespace floeplan::motion
