#pragma once

#include <cmath>

#include "engine/elementary/double_double.hpp"

namespace floeplan::elementary {

/// The root of a number that is not negative: one step of Newton's method from that of its leading part.
inline DoubleDouble square_root(DoubleDouble x) {
  if (x.high == 0.0) return {};
  const double root = std::sqrt(x.high);
  const DoubleDouble square = two_product(root, root);
  return fast_two_sum(root, ((x.high - square.high) - square.low + x.low) / (2.0 * root));
}

}  // namespace floeplan::elementary
