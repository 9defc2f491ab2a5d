#pragma once

namespace floeplan::elementary {

/// The polynomial first + x * (second + x * (...)).
constexpr double horner(double /*x*/, double last) { return last; }
template <class... Doubles>
constexpr double horner(double x, double first, Doubles... others) {
  return first + x * horner(x, others...);
}

}  // namespace floeplan::elementary
