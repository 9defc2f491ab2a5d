#pragma once

namespace floeplan::elementary {

/// The elementary functions of <cmath>, with identical bits on every x86-64 processor. The C library chooses
/// at program start between code with and without fused multiply-add, and their last bits differ.
/// Calls    the program uses the standard names (std::sin and so on), which are bound to these: see
///          interposition.cpp
/// Range    all doubles, as in <cmath> and annex F of the C standard: signed zeros, infinities, NaN,
///          subnormal numbers; errno is set as well. Comparisons with NaN may raise FE_INVALID
/// Error    below 0.56 units in the last place, sin and cos 0.8, tan 1, subnormal results 0.76; measured by
///          tests against 113 bits. If the exact value is a double, it is returned (pow(10, 3), log2(8),
///          cos(0))
/// Assumes  rounding to nearest; compiled without contraction (-ffp-contract=off)
/// Method   a table or a series around the nearest of some points where the function is known to 106 bits;
///          the leading terms in two doubles, the others in one
/// Source   Muller 2016, Elementary Functions: Algorithms and Implementation; Tang 1989 and 1990,
///          Table-driven implementation of the exponential, of the logarithm function, ACM Trans. Math.
///          Software 15 and 16. The compiler computes the tables from the series; constants were computed
///          with mpmath

struct SineCosine {
  double sine;
  double cosine;
};

[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
[[nodiscard]] SineCosine sincos(double x);  // the same bits as sin and cos
[[nodiscard]] double tan(double x);

[[nodiscard]] double asin(double x);
[[nodiscard]] double acos(double x);
[[nodiscard]] double atan(double x);
[[nodiscard]] double atan2(double y, double x);

[[nodiscard]] double exp(double x);
[[nodiscard]] double exp2(double x);
[[nodiscard]] double expm1(double x);
[[nodiscard]] double pow(double x, double y);
[[nodiscard]] double log(double x);
[[nodiscard]] double log2(double x);
[[nodiscard]] double log10(double x);
[[nodiscard]] double log1p(double x);

[[nodiscard]] double sinh(double x);
[[nodiscard]] double cosh(double x);
[[nodiscard]] double tanh(double x);
[[nodiscard]] double asinh(double x);
[[nodiscard]] double acosh(double x);
[[nodiscard]] double atanh(double x);

}  // namespace floeplan::elementary
