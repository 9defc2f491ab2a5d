#include "engine/elementary/exponential.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/elementary/constants.hpp"
#include "engine/elementary/elementary.hpp"
#include "engine/elementary/exceptions.hpp"
#include "engine/elementary/horner.hpp"

namespace floeplan::elementary {
namespace {

constexpr int powers = 128;
constexpr double beyond_all = 1100.0;  // exponents beyond overflow or underflow

// ln2 / 128; the first part is short enough for exact products with 18 bits.
constexpr double step_high = leading_bits(ln2.high, 33) / powers;
constexpr double step_low = ((ln2.high - leading_bits(ln2.high, 33)) + ln2.low) / powers;

/// Table of 2^(i/128), each entry computed from the one before.
constexpr std::array<DoubleDouble, powers> make_powers() {
  const DoubleDouble step{ln2.high / powers, ln2.low / powers};
  DoubleDouble factor{1.0};
  for (int n = 14; n > 0; --n)
    factor = DoubleDouble{1.0} + step * factor / DoubleDouble{static_cast<double>(n)};
  std::array<DoubleDouble, powers> result{DoubleDouble{1.0}};
  for (std::size_t i = 1; i < powers; ++i) result[i] = result[i - 1] * factor;
  return result;
}
constexpr auto power_of_two = make_powers();

/// 2^exponent, for exponents of normal numbers.
double normal_power(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// 2^(steps/128) * e^rest.
Scaled assembled(double steps, double rest) {
  const int whole = static_cast<int>(steps);
  const DoubleDouble power = power_of_two[static_cast<std::size_t>(whole & (powers - 1))];
  const double square = rest * rest;
  const double growth =
      rest + (0.5 * square + rest * square * (1.0 / 6 + rest * (1.0 / 24) + square * (1.0 / 120)));
  return {{power.high, power.low + power.high * growth}, whole >> 7};
}

}  // namespace

Scaled exponential(DoubleDouble x) {
  const double steps = (x.high * (powers / ln2.high) + to_integer) - to_integer;
  return assembled(steps, (x.high - steps * step_high) + (x.low - steps * step_low));
}

Scaled exponential_of_two(double x) {
  const double steps = (x * powers + to_integer) - to_integer;
  return assembled(steps, (x - steps / powers) * ln2.high);
}

double value_of(Scaled scaled) {
  const double fraction = rounded(scaled.fraction);
  if (scaled.exponent >= -1021 && scaled.exponent <= 1022) return fraction * normal_power(scaled.exponent);
  if (scaled.exponent > 0) {
    const double value = fraction * 0x1p1000 * normal_power(std::min(scaled.exponent - 1000, 1000));
    return std::isinf(value) ? overflow(1.0) : value;
  }
  const double value = fraction * 0x1p-1000 * normal_power(std::max(scaled.exponent + 1000, -1000));
  return value < std::numeric_limits<double>::min() ? too_small(value) : value;
}

DoubleDouble unscaled(Scaled scaled) {
  const double power = normal_power(scaled.exponent);
  return fast_two_sum(scaled.fraction.high * power, scaled.fraction.low * power);
}

double exp(double x) {
  if (std::abs(x) < beyond_all) return value_of(exponential({x, 0.0}));
  if (std::isnan(x)) return x + x;
  if (std::isinf(x)) return x > 0.0 ? x : 0.0;
  return x > 0.0 ? overflow(1.0) : underflow(1.0);
}

double exp2(double x) {
  if (std::abs(x) < beyond_all) return value_of(exponential_of_two(x));
  if (std::isnan(x)) return x + x;
  if (std::isinf(x)) return x > 0.0 ? x : 0.0;
  return x > 0.0 ? overflow(1.0) : underflow(1.0);
}

double expm1(double x) {
  if (std::abs(x) < 0x1p-54) return x;
  if (std::abs(x) < 0.3) {
    const double series =
        horner(x, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040, 1.0 / 40320, 1.0 / 362880,
               1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800.0);
    const DoubleDouble half_square = two_product(0.5 * x, x);
    const DoubleDouble sum = fast_two_sum(x, half_square.high);
    return sum.high + (sum.low + (half_square.low + x * x * x * series));
  }
  if (x < -50.0) return -1.0;
  if (x < 50.0) return rounded(unscaled(exponential({x, 0.0})) - DoubleDouble{1.0});
  return exp(x);
}

}  // namespace floeplan::elementary
