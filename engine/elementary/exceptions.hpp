#pragma once

namespace floeplan::elementary {

// Results that <math.h> requires if a function has no value, or none that a double can hold. errno and the
// floating-point flags are set, because libraries may check them.

/// NaN, for arguments at which the function is undefined; if `x` is NaN, `x` itself.
[[nodiscard]] double outside_domain(double x);
/// An infinity with the sign of `sign`, for a pole of the function.
[[nodiscard]] double at_pole(double sign);
/// An infinity with the sign of `sign`, for a value that is too large.
[[nodiscard]] double overflow(double sign);
/// A zero with the sign of `sign`, for a value that is too small.
[[nodiscard]] double underflow(double sign);
/// `value`, a subnormal number or zero, for an exact value too small for full precision.
[[nodiscard]] double too_small(double value);

}  // namespace floeplan::elementary
