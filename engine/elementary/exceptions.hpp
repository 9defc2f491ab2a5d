#pragma once

namespace floeplan::elementary {

// What <math.h> asks for where a function has no value or none that a double can hold: errno and the floating-point
// flags are set, as libraries may look for them.

/// Where the function is not defined: not a number; that of `x` itself where it is none.
[[nodiscard]] double outside_domain(double x);
/// An infinity with the sign of `sign`: the function has a pole there.
[[nodiscard]] double at_pole(double sign);
/// An infinity with the sign of `sign`: the value is too large.
[[nodiscard]] double overflow(double sign);
/// A zero with the sign of `sign`: the value is too small.
[[nodiscard]] double underflow(double sign);
/// `value`, a subnormal number or zero: the exact one is too small for all its digits.
[[nodiscard]] double too_small(double value);

}  // namespace floeplan::elementary
