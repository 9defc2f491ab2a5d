#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace floeplan::elementary {

/// A number as the unevaluated sum of two doubles. The second is below half a unit in the last place of the
/// first.
/// Error    of a product, a quotient and a sum of equal signs: below 2^-100 of the result; of a sum that
///          cancels: below 2^-100 of the larger operand
/// Assumes  rounding to nearest, no operation contracted or reordered, nothing near overflow or underflow
/// Source   Dekker 1971, A floating-point technique for extending the available precision, Numer. Math. 18;
///          Knuth 1997, The Art of Computer Programming, volume 2, section 4.2.2 (the sum without a
///          comparison)
struct DoubleDouble {
  double high{};
  double low{};
};

/// a + b, exactly.
constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a + b exactly; requires |a| >= |b| or a = 0.
constexpr DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// `x` cut to its first `bits` significant bits.
constexpr double leading_bits(double x, int bits) {
  const std::uint64_t all = ~std::uint64_t{0};
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & (all << (53 - bits)));
}

/// a * b exactly. The factors are cut, not rounded, into halves of 26 and 27 bits. Products of halves have at
/// most 53 bits, except that of the two lower ones (54); its last bit is below 2^-105 of the result.
constexpr DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  const double a_high = leading_bits(a, 26);
  const double b_high = leading_bits(b, 26);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// The same value, with the second part below half a unit of the first, as the operators below need it.
constexpr DoubleDouble normalised(DoubleDouble x) { return fast_two_sum(x.high, x.low); }

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble sum = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(sum.high, sum.low + low.low);
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = two_product(a.high, b.high);
  return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble{first};
  const double second = rest.high / b.high;
  const DoubleDouble last = rest - b * DoubleDouble{second};
  const DoubleDouble sum = fast_two_sum(first, second);
  return fast_two_sum(sum.high, sum.low + last.high / b.high);
}

/// The square root of a number that is not negative: one Newton step from the root of its leading part.
inline DoubleDouble square_root(DoubleDouble x) {
  if (x.high == 0.0) return {};
  const double root = std::sqrt(x.high);
  const DoubleDouble square = two_product(root, root);
  return fast_two_sum(root, ((x.high - square.high) - square.low + x.low) / (2.0 * root));
}

/// The closest double.
constexpr double rounded(DoubleDouble x) { return x.high + x.low; }

}  // namespace floeplan::elementary
