#include <cmath>

#include "engine/elementary/elementary.hpp"
#include "engine/elementary/exceptions.hpp"
#include "engine/elementary/quarter_turns.hpp"

namespace floeplan::elementary {
namespace {

constexpr double negligible_angle = 0x1p-27;  // sin x = tan x = x and cos x = 1 to within half a unit

// Taylor's series about 0, cut where a term is below 2^-58 of the result at pi/4; what is not rounded away of the leading
// terms goes into the lower part.

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
