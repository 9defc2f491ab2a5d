#include <array>
#include <cmath>
#include <limits>

#include "engine/elementary/constants.hpp"
#include "engine/elementary/double_double.hpp"
#include "engine/elementary/elementary.hpp"
#include "engine/elementary/exceptions.hpp"
#include "engine/elementary/horner.hpp"

namespace floeplan::elementary {
namespace {

constexpr int steps = 32;               // table steps for the quotient, from 0 to 1
constexpr int steps_of_series = 4;      // below this step the series needs no table
constexpr double negligible = 0x1p-27;  // below, atan x = asin x = x within half a unit in the last place
constexpr double flat = 0x1p-60;        // below, the arc differs from the quotient by less than 2^-120

/// Gregory's series, for |x| <= 1/32.
constexpr DoubleDouble arc_by_series(DoubleDouble x) {
  const DoubleDouble square = x * x;
  DoubleDouble sum{};
  for (int n = 12; n >= 0; --n)
    sum = DoubleDouble{n % 2 == 0 ? 1.0 : -1.0} / DoubleDouble{2.0 * n + 1.0} + square * sum;
  return x * sum;
}

/// Table of atan(i / 32). Each entry is the one before plus the difference of two arcs.
constexpr std::array<DoubleDouble, steps + 1> make_arcs() {
  std::array<DoubleDouble, steps + 1> arcs{};
  for (int i = 1; i <= steps; ++i) {
    const double product = static_cast<double>(i) * (i - 1) / (steps * steps);
    arcs[static_cast<std::size_t>(i)] =
        arcs[static_cast<std::size_t>(i - 1)] +
        arc_by_series(DoubleDouble{1.0 / steps} / DoubleDouble{1.0 + product});
  }
  return arcs;
}
constexpr auto arcs = make_arcs();

/// atan(y / x) for 2^-60 x <= y <= x (or y = 0), both within 2^+-500. With c the nearest table step:
/// atan(y/x) = atan(c) + atan((y - cx) / (x + cy)).
DoubleDouble arc_of_quotient(DoubleDouble y, DoubleDouble x) {
  const auto nearest = static_cast<int>(y.high / x.high * steps + 0.5);
  const int step = nearest < steps_of_series ? 0 : nearest;
  const double c = static_cast<double>(step) / steps;
  const double x_high = leading_bits(x.high, 40);  // so that its product with c is exact
  const DoubleDouble difference = two_sum(y.high, -c * x_high);
  const DoubleDouble over =
      two_sum(difference.high, difference.low + (y.low - c * ((x.high - x_high) + x.low)));
  const double under = x.high + c * y.high;
  const double under_low = step == 0 ? x.low : (x.high - under) + c * y.high;

  const double t = over.high / under;
  const DoubleDouble back = two_product(t, under);
  const double t_low = (((over.high - back.high) - back.low) + (over.low - t * under_low)) / under;
  const double z = t * t;
  const double series =
      horner(z, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17);
  const DoubleDouble arc = arcs[static_cast<std::size_t>(step)];
  const DoubleDouble sum = fast_two_sum(arc.high, t);
  return step == 0 ? DoubleDouble{t, t_low + t * z * series}
                   : fast_two_sum(sum.high, sum.low + (arc.low + t_low + t * z * series));
}

/// The angle of (x, y). Both are at least zero, and not both zero.
DoubleDouble arc_in_quadrant(DoubleDouble y, DoubleDouble x) {
  if (y.high > x.high) return half_pi - arc_in_quadrant(x, y);
  if (y.high < flat * x.high) return {y.high / x.high, 0.0};
  double scale = 1.0;
  if (x.high > 0x1p500) scale = 0x1p-600;
  if (x.high < 0x1p-400) scale = 0x1p600;
  return arc_of_quotient({y.high * scale, y.low * scale}, {x.high * scale, x.low * scale});
}

/// sqrt(1 - x^2).
DoubleDouble other_leg(double x) { return square_root(two_sum(1.0, -x) * two_sum(1.0, x)); }

}  // namespace

double atan(double x) {
  const double size = std::abs(x);
  if (std::isnan(x)) return x + x;
  if (size < negligible) return x;
  if (std::isinf(x)) return std::copysign(half_pi.high, x);
  return std::copysign(rounded(arc_in_quadrant({size}, {1.0})), x);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  double size_x = std::abs(x);
  double size_y = std::abs(y);
  if (std::isinf(x) || std::isinf(y)) {
    size_x = std::isinf(x) ? 1.0 : 0.0;
    size_y = std::isinf(y) ? 1.0 : 0.0;
  }
  if (size_y == 0.0) return std::copysign(std::signbit(x) ? pi.high : 0.0, y);
  if (size_x == 0.0) return std::copysign(half_pi.high, y);
  const DoubleDouble arc = arc_in_quadrant({size_y}, {size_x});
  const double angle = rounded(x < 0.0 ? pi - arc : arc);
  if (angle < std::numeric_limits<double>::min()) return std::copysign(too_small(angle), y);
  return std::copysign(angle, y);
}

double asin(double x) {
  const double size = std::abs(x);
  if (!(size <= 1.0)) return outside_domain(x);
  if (size < negligible) return x;
  return std::copysign(rounded(arc_in_quadrant({size}, other_leg(x))), x);
}

double acos(double x) {
  const double size = std::abs(x);
  if (!(size <= 1.0)) return outside_domain(x);
  if (x == 1.0) return 0.0;
  if (size < 0x1p-60) return half_pi.high;
  const DoubleDouble arc = arc_in_quadrant(other_leg(x), {size});
  return rounded(x < 0.0 ? pi - arc : arc);
}

}  // namespace floeplan::elementary
