#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/elementary/constants.hpp"
#include "engine/elementary/double_double.hpp"
#include "engine/elementary/elementary.hpp"
#include "engine/elementary/exceptions.hpp"

namespace floeplan::elementary {
namespace {

/// An angle as a number of quarter turns and a rest.
struct QuarterTurns {
  int quadrant{};  // 0 to 3
  DoubleDouble rest;
};

__extension__ using Wide = unsigned __int128;

constexpr double moderate = 0x1p20;

// pi/2 in three pieces of 33 bits and a rest.
constexpr double piece_1 = 0x1.921fb544p+0;
constexpr double piece_2 = 0x1.0b4611a6p-34;
constexpr double piece_3 = 0x1.3198a2ep-69;
constexpr double piece_4 = 0x1.b839a252049c1p-104;

QuarterTurns of_moderate(double x) {
  const double turns = (x * (2.0 / std::numbers::pi) + to_integer) - to_integer;
  const double first = x - turns * piece_1;  // exact, as are the two sums below
  const DoubleDouble second = two_sum(first, -turns * piece_2);
  const DoubleDouble third = two_sum(second.high, -turns * piece_3);
  return {static_cast<int>(turns) & 3, fast_two_sum(third.high, third.low + (second.low - turns * piece_4))};
}

// Bits of 2/pi after the binary point, with a word of zeros in front.
constexpr std::array<std::uint64_t, 20> two_over_pi{
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561,
    0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41,
    0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d, 0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};

/// 64 bits of 2/pi, from this bit on.
std::uint64_t bits_from(std::size_t bit) {
  const std::size_t word = bit / 64;
  const std::size_t shift = bit % 64;
  if (shift == 0) return two_over_pi[word];
  return (two_over_pi[word] << shift) | (two_over_pi[word + 1] >> (64 - shift));
}

/// x = mantissa * 2^exponent. Bits of 2/pi that give whole turns are left out. The next 192 bits give a
/// product whose first two bits are the quadrant; the other 190 are the rest.
QuarterTurns of_large(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t mantissa = (bits & 0x000fffffffffffff) | 0x0010000000000000;
  const int exponent = static_cast<int>((bits >> 52) & 0x7ff) - 1075;
  const auto first = static_cast<std::size_t>(exponent + 62);  // -2: whole turns, 64: the word of zeros

  std::array<std::uint64_t, 3> product{};  // the lowest word comes last
  std::uint64_t carry = 0;
  for (std::size_t i = 3; i-- > 0;) {
    const Wide word = static_cast<Wide>(mantissa) * bits_from(first + 64 * i) + carry;
    product[i] = static_cast<std::uint64_t>(word);
    carry = static_cast<std::uint64_t>(word >> 64);
  }
  int quadrant = static_cast<int>(product[0] >> 62);
  product[0] = (product[0] << 2) | (product[1] >> 62);
  product[1] = (product[1] << 2) | (product[2] >> 62);
  product[2] <<= 2;
  const bool above_half = (product[0] >> 63) != 0;
  if (above_half) {  // the rest counts backwards from the next quarter turn; the last bit does not matter
    quadrant = (quadrant + 1) & 3;
    for (std::uint64_t& word : product) word = ~word;
  }
  DoubleDouble part;
  for (std::size_t i = 3; i-- > 0;) {
    const double unit = std::ldexp(1.0, -64 * (static_cast<int>(i) + 1));
    const auto upper = static_cast<double>(product[i] >> 32);
    const auto lower = static_cast<double>(product[i] & 0xffffffff);
    part = DoubleDouble{upper * 0x1p32 * unit} + (DoubleDouble{lower * unit} + part);
  }
  const DoubleDouble rest = part * half_pi;
  return {quadrant, above_half ? -rest : rest};
}

/// Reduces `x` in radians, finite, of any size. The rest lies within [-pi/4, pi/4], exceeded by at most 1e-10
/// of it.
/// Error    below 2^-68 of the rest
/// Method   up to 2^20 by Cody and Waite: multiples of pi/2 in pieces of 33 bits, whose products are exact;
///          beyond by Payne and Hanek: only those bits of the product with 2/pi are computed that matter
/// Source   Cody and Waite 1980, Software Manual for the Elementary Functions; Payne and Hanek 1983, Radian
///          reduction for trigonometric functions, ACM SIGNUM Newsletter 18. Digits of pi computed with
///          mpmath
QuarterTurns quarter_turns(double x) {
  const double size = std::abs(x);
  if (size <= std::numbers::pi / 4.0) return {0, {x, 0.0}};
  if (size < moderate) return of_moderate(x);
  const QuarterTurns turns = of_large(size);
  if (x > 0.0) return turns;
  return {-turns.quadrant & 3, -turns.rest};
}

constexpr double negligible_angle = 0x1p-27;  // sin x = tan x = x and cos x = 1 to within half a unit

// Taylor's series around 0, ended where a term is below 2^-58 of the result at pi/4. Rounding errors of the
// leading terms go into the lower part.

DoubleDouble sine_of_rest(DoubleDouble x) {
  const double z = x.high * x.high;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double low = -1.0 / 6 + z * (1.0 / 120);
  const double middle =
      (-1.0 / 5040 + z * (1.0 / 362880)) + z2 * (-1.0 / 39916800 + z * (1.0 / 6227020800.0));
  const double high = -1.0 / 1307674368000.0 + z * (1.0 / 355687428096000.0);
  const double series = low + (z2 * middle + z4 * z2 * high);
  return {x.high, x.high * z * series + x.low * (1.0 - 0.5 * z)};
}

DoubleDouble cosine_of_rest(DoubleDouble x) {
  const DoubleDouble z = two_product(x.high, x.high);
  const double z2 = z.high * z.high;
  const double z4 = z2 * z2;
  const double low = 1.0 / 24 + z.high * (-1.0 / 720);
  const double middle =
      (1.0 / 40320 + z.high * (-1.0 / 3628800)) + z2 * (1.0 / 479001600 + z.high * (-1.0 / 87178291200.0));
  const double series = low + (z2 * middle + z4 * z2 * (1.0 / 20922789888000.0));
  const DoubleDouble leading = fast_two_sum(1.0, -0.5 * z.high);
  return {leading.high, leading.low + (z2 * series - 0.5 * z.low - x.high * x.low)};
}

}  // namespace

double sin(double x) {
  if (std::abs(x) < negligible_angle) return x;
  if (!std::isfinite(x)) return outside_domain(x);
  const QuarterTurns turns = quarter_turns(x);
  const bool odd = (turns.quadrant & 1) != 0;
  const double value = rounded(odd ? cosine_of_rest(turns.rest) : sine_of_rest(turns.rest));
  return (turns.quadrant & 2) != 0 ? -value : value;
}

double cos(double x) {
  if (std::abs(x) < negligible_angle) return 1.0;
  if (!std::isfinite(x)) return outside_domain(x);
  const QuarterTurns turns = quarter_turns(x);
  const bool odd = (turns.quadrant & 1) != 0;
  const double value = rounded(odd ? sine_of_rest(turns.rest) : cosine_of_rest(turns.rest));
  return ((turns.quadrant + 1) & 2) != 0 ? -value : value;
}

SineCosine sincos(double x) {
  if (std::abs(x) < negligible_angle) return {x, 1.0};
  if (!std::isfinite(x)) return {outside_domain(x), outside_domain(x)};
  const QuarterTurns turns = quarter_turns(x);
  const double sine = rounded(sine_of_rest(turns.rest));
  const double cosine = rounded(cosine_of_rest(turns.rest));
  switch (turns.quadrant) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

double tan(double x) {
  if (std::abs(x) < negligible_angle) return x;
  if (!std::isfinite(x)) return outside_domain(x);
  const QuarterTurns turns = quarter_turns(x);
  const DoubleDouble sine = normalised(sine_of_rest(turns.rest));
  const DoubleDouble cosine = normalised(cosine_of_rest(turns.rest));
  return rounded((turns.quadrant & 1) != 0 ? -cosine / sine : sine / cosine);
}

}  // namespace floeplan::elementary
