#include "engine/elementary/exceptions.hpp"

#include <cerrno>
#include <cfenv>
#include <cmath>
#include <limits>

namespace floeplan::elementary {
namespace {

double signalled(double value, int error, int flags) {
  errno = error;
  std::feraiseexcept(flags);
  return value;
}

}  // namespace

double outside_domain(double x) {
  if (std::isnan(x)) return x + x;
  return signalled(std::numeric_limits<double>::quiet_NaN(), EDOM, FE_INVALID);
}

double at_pole(double sign) {
  return signalled(std::copysign(std::numeric_limits<double>::infinity(), sign), ERANGE, FE_DIVBYZERO);
}

double overflow(double sign) {
  return signalled(std::copysign(std::numeric_limits<double>::infinity(), sign), ERANGE,
                   FE_OVERFLOW | FE_INEXACT);
}

double underflow(double sign) {
  return signalled(std::copysign(0.0, sign), ERANGE, FE_UNDERFLOW | FE_INEXACT);
}

double too_small(double value) { return signalled(value, ERANGE, FE_UNDERFLOW | FE_INEXACT); }

}  // namespace floeplan::elementary
