#pragma once

#include <cmath>

#include "engine/core/units.hpp"
#include "engine/motion/plane_current.hpp"

namespace floeplan::planning {

/// Displacement of a vehicle by the current: metres on the ground along the axes of the plane.
struct CarriedWay {
  double x_m{};
  double y_m{};

  [[nodiscard]] core::Metres length() const { return {std::hypot(x_m, y_m)}; }
  /// The constant current with this displacement in `time`.
  [[nodiscard]] motion::CurrentXy over(core::Seconds time) const {
    return {x_m / time.count(), y_m / time.count()};
  }

  friend CarriedWay operator+(CarriedWay a, CarriedWay b) { return {a.x_m + b.x_m, a.y_m + b.y_m}; }
  friend CarriedWay operator-(CarriedWay a, CarriedWay b) { return {a.x_m - b.x_m, a.y_m - b.y_m}; }
};

[[nodiscard]] inline CarriedWay operator*(motion::CurrentXy current, core::Seconds time) {
  return {current.x_m_s * time.count(), current.y_m_s * time.count()};
}

}  // namespace floeplan::planning
