#include "engine/vehicle/thruster.hpp"

#include <cmath>

namespace floeplan::vehicle {

core::Watts thruster_power(core::MetresPerSecond speed) {
  const double at_propeller_w = std::pow(speed.value / 0.5213, 1.0 / 0.3467);
  return {4.3378 + 2.0227 * at_propeller_w};
}

}  // namespace floeplan::vehicle
