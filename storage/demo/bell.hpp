#pragma once

#include <cmath>

namespace floeplan::demo {

/// 1 in the middle, 1/e at a distance of `width` from it; both in the same unit.
[[nodiscard]] inline double bell(double distance, double width) {
  return std::exp(-(distance / width) * (distance / width));
}

}  // namespace floeplan::demo
