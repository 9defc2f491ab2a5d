#pragma once

#include <limits>
#include <vector>

namespace floeplan::ocean {

/// Marks an unknown value inside arrays; functions do not return it.
inline constexpr float missing_sample = std::numeric_limits<float>::quiet_NaN();

/// Currents at one time and level at the points of a mesh or the nodes of a grid, in m/s towards true east
/// and true north; NaN if missing.
struct PointVelocities {
  std::vector<float> east;
  std::vector<float> north;
};

}  // namespace floeplan::ocean
