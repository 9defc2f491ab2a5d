#include <cmath>
#include <limits>

#include "engine/elementary/elementary.hpp"
#include "engine/elementary/exceptions.hpp"
#include "engine/elementary/exponential.hpp"
#include "engine/elementary/logarithm.hpp"

namespace floeplan::elementary {
namespace {

enum class Parity { none, even, odd };  // none: not an integer

Parity parity(double y) {
  if (std::abs(y) >= 0x1p53) return Parity::even;
  const double whole = std::trunc(y);
  if (whole != y) return Parity::none;
  return 2.0 * std::trunc(0.5 * whole) == whole ? Parity::even : Parity::odd;
}

/// pow(x, y) if x is zero or infinite, or y is infinite.
double at_the_ends(double x, double y) {
  const double size = std::abs(x);
  if (std::isinf(y)) {
    if (size == 1.0) return 1.0;
    return (size > 1.0) == (y > 0.0) ? std::numeric_limits<double>::infinity() : 0.0;
  }
  const double sign = parity(y) == Parity::odd ? std::copysign(1.0, x) : 1.0;
  const bool grows = (size > 1.0) == (y > 0.0);
  if (!grows) return std::copysign(0.0, sign);
  return size == 0.0 ? at_pole(sign) : std::copysign(std::numeric_limits<double>::infinity(), sign);
}

/// x^y for positive x, both finite, |y| within 2^+-65.
double of_positive(double x, double y) {
  const DoubleDouble log = logarithm(x);
  if (std::abs(log.high * y) > 1000.0) return log.high * y > 0.0 ? overflow(1.0) : underflow(1.0);
  const DoubleDouble product = two_product(log.high, y);
  return value_of(exponential(fast_two_sum(product.high, product.low + log.low * y)));
}

}  // namespace

double pow(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const double size = std::abs(x);
  if (size == 0.0 || std::isinf(x) || std::isinf(y)) return at_the_ends(x, y);
  const Parity kind = x < 0.0 ? parity(y) : Parity::even;
  if (kind == Parity::none) return outside_domain(x);
  const double sign = kind == Parity::odd ? -1.0 : 1.0;
  if (size == 1.0 || std::abs(y) < 0x1p-65) return sign;  // no logarithm of a double exceeds 745
  if (std::abs(y) > 0x1p65) return (size > 1.0) == (y > 0.0) ? overflow(sign) : underflow(sign);
  return sign * of_positive(size, y);
}

}  // namespace floeplan::elementary
