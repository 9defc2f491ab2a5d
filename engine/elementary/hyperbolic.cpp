#include <cmath>
#include <limits>

#include "engine/elementary/constants.hpp"
#include "engine/elementary/double_double.hpp"
#include "engine/elementary/elementary.hpp"
#include "engine/elementary/exceptions.hpp"
#include "engine/elementary/exponential.hpp"
#include "engine/elementary/horner.hpp"
#include "engine/elementary/logarithm.hpp"

namespace floeplan::elementary {
namespace {

constexpr double negligible_argument =
    0x1p-28;                               // below, each odd function equals its argument within half a unit
constexpr double near_zero = 0.3;          // below, the series are shorter than differences of exponentials
constexpr double far_out = 40.0;           // above, e^-x is below 2^-115 of e^x
constexpr double large_argument = 0x1p28;  // above, sqrt(x^2 + 1) equals x within 2^-57

/// sinh x, and below cosh x, for |x| < 0.3, by Taylor's series.
DoubleDouble sinh_near_zero(double x) {
  const double z = x * x;
  return {
      x, x * z * horner(z, 1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800.0)};
}
DoubleDouble cosh_near_zero(double x) {
  const DoubleDouble half_square = two_product(0.5 * x, x);
  const DoubleDouble sum = fast_two_sum(1.0, half_square.high);
  const double z = x * x;
  return {sum.high,
          sum.low + (half_square.low +
                     z * z * horner(z, 1.0 / 24, 1.0 / 720, 1.0 / 40320, 1.0 / 3628800, 1.0 / 479001600))};
}

/// e^x / 2 for x >= far_out.
double half_of_exponential(double x) {
  if (x > 1000.0) return overflow(1.0);
  Scaled scaled = exponential({x, 0.0});
  scaled.exponent -= 1;
  return value_of(scaled);
}

struct Exponentials {
  DoubleDouble of_x;
  DoubleDouble of_minus_x;
};
Exponentials exponentials(double x) {
  return {unscaled(exponential({x, 0.0})), unscaled(exponential({-x, 0.0}))};
}

/// log(2x) for a large x.
DoubleDouble log_of_double(double x) { return logarithm(x) + ln2; }

}  // namespace

double sinh(double x) {
  const double size = std::abs(x);
  if (!std::isfinite(x)) return x + x;
  if (size < negligible_argument) return x;
  if (size < near_zero) return rounded(sinh_near_zero(x));
  if (size > far_out) return std::copysign(1.0, x) * half_of_exponential(size);
  const auto [up, down] = exponentials(x);
  return 0.5 * rounded(up - down);
}

double cosh(double x) {
  const double size = std::abs(x);
  if (!std::isfinite(x)) return x * x;
  if (size < near_zero) return rounded(cosh_near_zero(x));
  if (size > far_out) return half_of_exponential(size);
  const auto [up, down] = exponentials(x);
  return 0.5 * rounded(up + down);
}

double tanh(double x) {
  const double size = std::abs(x);
  if (std::isnan(x)) return x + x;
  if (size < negligible_argument) return x;
  if (size < near_zero) return rounded(normalised(sinh_near_zero(x)) / normalised(cosh_near_zero(x)));
  if (size > far_out) return std::copysign(1.0, x);
  const auto [up, down] = exponentials(x);
  return rounded((up - down) / (up + down));
}

double asinh(double x) {
  const double size = std::abs(x);
  if (!std::isfinite(x)) return x + x;
  if (size < negligible_argument) return x;
  if (size > large_argument) return std::copysign(rounded(log_of_double(size)), x);
  // log(1 + u) with u = x + x^2 / (1 + sqrt(1 + x^2))
  const DoubleDouble square = two_product(size, size);
  const DoubleDouble root = square_root(DoubleDouble{1.0} + square);
  const DoubleDouble u = DoubleDouble{size} + square / (DoubleDouble{1.0} + root);
  return std::copysign(rounded(logarithm(DoubleDouble{1.0} + u)), x);
}

double acosh(double x) {
  if (!(x >= 1.0)) return outside_domain(x);
  if (std::isinf(x)) return x;
  if (x > large_argument) return rounded(log_of_double(x));
  // log(1 + u) with u = (x - 1) + sqrt((x - 1) (x + 1))
  const DoubleDouble above_one = two_sum(x, -1.0);
  const DoubleDouble u = above_one + square_root(above_one * two_sum(x, 1.0));
  return rounded(logarithm(DoubleDouble{1.0} + u));
}

double atanh(double x) {
  const double size = std::abs(x);
  if (size == 1.0) return at_pole(x);
  if (!(size < 1.0)) return outside_domain(x);
  if (size < negligible_argument) return x;
  const DoubleDouble u = DoubleDouble{2.0 * size} / two_sum(1.0, -size);
  return std::copysign(0.5 * rounded(logarithm(DoubleDouble{1.0} + u)), x);
}

}  // namespace floeplan::elementary
