#pragma once

#include "engine/elementary/double_double.hpp"

namespace floeplan::elementary {

/// The number fraction * 2^exponent.
struct Scaled {
  DoubleDouble fraction;  // between 0.99 and 2.01; its lower part may reach 2^-8 of the higher
  int exponent{};
};

/// e^(x.high + x.low), for |x| < 1100 and a lower part below 2^-40.
/// Error    below 2^-60 of the value, in addition to that of x
/// Method   the nearest of 128 powers of two, and five terms of the series for the rest
[[nodiscard]] Scaled exponential(DoubleDouble x);

/// 2^x, for |x| < 1100.
[[nodiscard]] Scaled exponential_of_two(double x);

/// The nearest double. For exponents out of range an infinity or zero, and errno is set.
[[nodiscard]] double value_of(Scaled scaled);

/// The value in two doubles, for exponents between -900 and 1000.
[[nodiscard]] DoubleDouble unscaled(Scaled scaled);

}  // namespace floeplan::elementary
