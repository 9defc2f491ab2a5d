#pragma once

namespace floeplan::elementary {

/// The elementary functions of <cmath> with the same bits on every x86-64 processor. Those of the C library choose
/// between code with and without fused multiply-add when the program starts, and their last bits differ.
/// Calls    not by these names: the rest of the program says std::sin and so on (see interposition.cpp)
/// Range    all doubles, as <cmath> and annex F of the C standard have it: signed zeros, infinities, not-a-numbers,
///          subnormal numbers; errno as well. Comparisons with a not-a-number may raise FE_INVALID
/// Error    below 0.56 units in the last place, sin and cos 0.8, tan 1, subnormal results 0.76; measured by tests
///          against 113 bits.
///          Where the exact value is a double it is returned (pow(10, 3), log2(8), cos(0))
/// Assumes  rounding to nearest; compiled without contraction (-ffp-contract=off)
/// Method   a table or a series about the nearest of some points where the function is known to 106 bits, the leading
///          terms in two doubles, the others in one
/// Source   Muller 2016, Elementary Functions: Algorithms and Implementation; Tang 1989 and 1990, Table-driven
///          implementation of the exponential, of the logarithm function, ACM Trans. Math. Software 15 and 16. Tables are
///          computed by the compiler from the series; constants were computed with mpmath

struct SineCosine {
  double sine;
  double cosine;
};

[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
[[nodiscard]] SineCosine sincos(double x);  // the bits of both
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
