#pragma once

#include <limits>
#include <vector>

namespace floeplan::ocean {

/// Marks a value that is not known, inside arrays alone.
inline constexpr float missing_sample = std::numeric_limits<float>::quiet_NaN();

/// Currents of one time and level at the points of a mesh or the nodes of a grid, m/s towards true east and true north;
/// NaN where missing.
struct PointVelocities {
  std::vector<float> east;
  std::vector<float> north;
};

}  // namespace floeplan::ocean
