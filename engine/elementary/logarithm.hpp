#pragma once

#include "engine/elementary/double_double.hpp"

namespace floeplan::elementary {

/// The natural logarithm of a positive, finite number.
/// Error    below 2^-66 of the value
/// Method   x without its power of two; c is the nearest multiple of 1/128. log(c) comes from a table; log(1
///          + r), with r = (x - c) / c, from its series, whose first two terms are kept exactly
[[nodiscard]] DoubleDouble logarithm(double x);

/// Natural logarithm of x.high + x.low, which must be positive, normalised and at least 2^-28 away from one.
[[nodiscard]] DoubleDouble logarithm(DoubleDouble x);

}  // namespace floeplan::elementary
