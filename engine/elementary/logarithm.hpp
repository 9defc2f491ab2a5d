#pragma once

#include "engine/elementary/double_double.hpp"

namespace floeplan::elementary {

/// The natural logarithm of a positive, finite number.
/// Error    below 2^-66 of the value
/// Method   the nearest 128th c to the number without its power of two; log(c) from a table and the series of
///          log(1 + r) with r = (x - c) / c, whose first two terms are kept exactly
[[nodiscard]] DoubleDouble logarithm(double x);

/// Natural logarithm of x.high + x.low, which is positive, normalised and 2^-28 or more from one.
[[nodiscard]] DoubleDouble logarithm(DoubleDouble x);

}  // namespace floeplan::elementary
