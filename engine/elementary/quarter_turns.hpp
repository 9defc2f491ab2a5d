#pragma once

#include "engine/elementary/double_double.hpp"

namespace floeplan::elementary {

/// An angle as whole quarter turns and a rest.
struct QuarterTurns {
  int quadrant{};  // 0 to 3
  DoubleDouble rest;
};

/// `x` in radians, finite, of any size. The rest lies between -pi/4 and pi/4, or beyond by 1e-10 of it.
/// Error    below 2^-68 of the rest
/// Method   to 2^20 by Cody and Waite: multiples of pi/2 in pieces of 33 bits, whose products are exact; beyond by Payne
///          and Hanek: of the product with 2/pi only those bits are formed that matter
/// Source   Cody and Waite 1980, Software Manual for the Elementary Functions; Payne and Hanek 1983, Radian reduction for
///          trigonometric functions, ACM SIGNUM Newsletter 18. Digits of pi computed with mpmath
[[nodiscard]] QuarterTurns quarter_turns(double x);

}  // namespace floeplan::elementary
