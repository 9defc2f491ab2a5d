#pragma once

#include "engine/elementary/double_double.hpp"

namespace floeplan::elementary {

// To 106 bits, computed with mpmath.
inline constexpr DoubleDouble pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
inline constexpr DoubleDouble ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
inline constexpr DoubleDouble per_ln2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
inline constexpr DoubleDouble per_ln10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

/// Adding and subtracting this rounds a number below 2^51 to the nearest integer, ties to even.
inline constexpr double to_integer = 0x1.8p52;

}  // namespace floeplan::elementary
