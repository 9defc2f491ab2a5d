#include "engine/elementary/logarithm.hpp"

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

// ln2; the first part is short enough for exact products with 11 bits.
constexpr double ln2_high = leading_bits(ln2.high, 42);
constexpr double ln2_low = (ln2.high - ln2_high) + ln2.low;

constexpr std::uint64_t root_of_half = 0x3fe6a09e667f3bcd;
constexpr int parts = 128;
constexpr int first_part = 90;  // of 128, just below sqrt(1/2)
constexpr int last_part = 182;  // just above sqrt(2)

struct Point {
  double inverse{};
  DoubleDouble log;
};

/// Table of log(c), by the series of the inverse hyperbolic tangent of (c - 1) / (c + 1).
constexpr std::array<Point, last_part - first_part + 1> make_points() {
  std::array<Point, last_part - first_part + 1> points{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double c = static_cast<double>(first_part + static_cast<int>(i)) / parts;
    const DoubleDouble s = DoubleDouble{c - 1.0} / DoubleDouble{c + 1.0};
    const DoubleDouble square = s * s;
    DoubleDouble sum{};
    for (int n = 24; n >= 0; --n) sum = DoubleDouble{1.0} / DoubleDouble{2.0 * n + 1.0} + square * sum;
    points[i] = {1.0 / c, DoubleDouble{2.0} * s * sum};
  }
  return points;
}
constexpr auto points = make_points();

/// The logarithm: special values for arguments without one, `formula` for all others.
template <class Formula>
double logarithmic(double x, const Formula& formula) {
  if (x > 0.0 && x <= std::numeric_limits<double>::max()) return formula(x);
  if (x == 0.0) return at_pole(-1.0);
  if (x > 0.0) return x;
  return outside_domain(x);
}

}  // namespace

DoubleDouble logarithm(double x) {
  auto bits = std::bit_cast<std::uint64_t>(x);
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    bits = std::bit_cast<std::uint64_t>(x * 0x1p54);
    exponent = -54;
  }
  const int shift = static_cast<int>(static_cast<std::int64_t>(bits - root_of_half) >> 52);
  exponent += shift;
  const double z =
      std::bit_cast<double>(bits - (static_cast<std::uint64_t>(static_cast<std::int64_t>(shift)) << 52));

  const int part = static_cast<int>(z * parts + 0.5);
  const double c = static_cast<double>(part) / parts;
  const Point& point = points[static_cast<std::size_t>(part - first_part)];
  const double f = z - c;                                     // exact
  const double r_high = leading_bits(f * point.inverse, 26);  // its product with c, and its square, are exact
  const double r_low = (f - r_high * c) * point.inverse;
  const double r = r_high + r_low;
  const double series = horner(r, 1.0 / 3, -1.0 / 4, 1.0 / 5, -1.0 / 6, 1.0 / 7, -1.0 / 8, 1.0 / 9);
  const double half_square = 0.5 * (r_high * r_high);
  const double half_square_low = r_low * (r_high + 0.5 * r_low);

  const double k = exponent;
  const DoubleDouble base = two_sum(k * ln2_high, point.log.high);
  const DoubleDouble first = two_sum(base.high, r_high);
  const DoubleDouble second = two_sum(first.high, -half_square);
  const double low = (base.low + first.low + second.low + (k * ln2_low + point.log.low)) +
                     (r_low - half_square_low + r * r * r * series);
  return fast_two_sum(second.high, low);
}

DoubleDouble logarithm(DoubleDouble x) {
  const DoubleDouble log = logarithm(x.high);
  const DoubleDouble sum = two_sum(log.high, x.low / x.high);
  return fast_two_sum(sum.high, sum.low + log.low);
}

double log(double x) {
  return logarithmic(x, [](double y) { return rounded(logarithm(y)); });
}

double log2(double x) {
  return logarithmic(x, [](double y) { return rounded(logarithm(y) * per_ln2); });
}

double log10(double x) {
  return logarithmic(x, [](double y) { return rounded(logarithm(y) * per_ln10); });
}

double log1p(double x) {
  if (std::abs(x) < 0x1p-54) return x;
  if (std::abs(x) < 0x1p-20) return x - x * x * (0.5 - x * (1.0 / 3));
  if (x > -1.0 && x <= std::numeric_limits<double>::max()) return rounded(logarithm(two_sum(1.0, x)));
  if (x == -1.0) return at_pole(-1.0);
  if (x > 0.0) return x;
  return outside_domain(x);
}

}  // namespace floeplan::elementary
