#pragma once

#include <cmath>

#include "engine/core/units.hpp"

namespace floeplan::geo {

/// Horizontal velocity in the local east-north frame. A current points where the water goes.
struct VelocityEn {
  core::MetresPerSecond east{};
  core::MetresPerSecond north{};

  friend bool operator==(VelocityEn, VelocityEn) = default;
};

[[nodiscard]] inline VelocityEn sum(VelocityEn a, VelocityEn b) {
  return {a.east + b.east, a.north + b.north};
}

[[nodiscard]] inline core::MetresPerSecond strength(VelocityEn velocity) {
  return {std::hypot(velocity.east.value, velocity.north.value)};
}

}  // namespace floeplan::geo
