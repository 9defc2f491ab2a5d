#include <gtest/gtest.h>

#include <cerrno>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/elementary/elementary.hpp"

namespace floeplan::elementary::special_values_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

/// Expects two equal values, with the signs of zeros and infinities. All not-a-numbers count as one.
void expect_same(double value, double wanted, double x, double y = 0.0) {
  if (std::isnan(wanted)) {
    EXPECT_TRUE(std::isnan(value)) << value << " of " << x << ' ' << y;
    return;
  }
  EXPECT_EQ(value, wanted) << "of " << x << ' ' << y;
  EXPECT_EQ(std::signbit(value), std::signbit(wanted)) << "of " << x << ' ' << y;
}

struct Case {
  double (*function)(double);
  double x;
  double wanted;
  int error;  // errno
};

TEST(SpecialValues, OfOneArgumentAreThoseOfTheStandard) {
  const std::vector<Case> cases{
      {elementary::sin, -0.0, -0.0, 0},
      {elementary::sin, infinity, not_a_number, EDOM},
      {elementary::cos, -infinity, not_a_number, EDOM},
      {elementary::cos, 0.0, 1.0, 0},
      {elementary::tan, -0.0, -0.0, 0},
      {elementary::tan, infinity, not_a_number, EDOM},
      {elementary::asin, -0.0, -0.0, 0},
      {elementary::asin, 1.0, pi / 2, 0},
      {elementary::asin, -1.0, -pi / 2, 0},
      {elementary::asin, 1.0000000000000002, not_a_number, EDOM},
      {elementary::acos, 1.0, 0.0, 0},
      {elementary::acos, 0.0, pi / 2, 0},
      {elementary::acos, -1.0, pi, 0},
      {elementary::acos, -infinity, not_a_number, EDOM},
      {elementary::atan, -0.0, -0.0, 0},
      {elementary::atan, -infinity, -pi / 2, 0},
      {elementary::exp, -0.0, 1.0, 0},
      {elementary::exp, infinity, infinity, 0},
      {elementary::exp, -infinity, 0.0, 0},
      {elementary::exp, 710.0, infinity, ERANGE},
      {elementary::exp, 1e300, infinity, ERANGE},
      {elementary::exp, -746.0, 0.0, ERANGE},
      {elementary::exp, -1e300, 0.0, ERANGE},
      {elementary::exp2, 1024.0, infinity, ERANGE},
      {elementary::exp2, -1e300, 0.0, ERANGE},
      {elementary::expm1, -0.0, -0.0, 0},
      {elementary::expm1, -infinity, -1.0, 0},
      {elementary::expm1, infinity, infinity, 0},
      {elementary::expm1, 800.0, infinity, ERANGE},
      {elementary::log, 1.0, 0.0, 0},
      {elementary::log, 0.0, -infinity, ERANGE},
      {elementary::log, -0.0, -infinity, ERANGE},
      {elementary::log, -1.0, not_a_number, EDOM},
      {elementary::log, -infinity, not_a_number, EDOM},
      {elementary::log, infinity, infinity, 0},
      {elementary::log2, 0.0, -infinity, ERANGE},
      {elementary::log10, -2.0, not_a_number, EDOM},
      {elementary::log1p, -0.0, -0.0, 0},
      {elementary::log1p, -1.0, -infinity, ERANGE},
      {elementary::log1p, -2.0, not_a_number, EDOM},
      {elementary::log1p, infinity, infinity, 0},
      {elementary::sinh, -0.0, -0.0, 0},
      {elementary::sinh, -infinity, -infinity, 0},
      {elementary::sinh, -711.0, -infinity, ERANGE},
      {elementary::cosh, -infinity, infinity, 0},
      {elementary::cosh, 1e300, infinity, ERANGE},
      {elementary::tanh, -0.0, -0.0, 0},
      {elementary::tanh, -infinity, -1.0, 0},
      {elementary::asinh, -0.0, -0.0, 0},
      {elementary::asinh, -infinity, -infinity, 0},
      {elementary::acosh, 1.0, 0.0, 0},
      {elementary::acosh, 0.5, not_a_number, EDOM},
      {elementary::acosh, infinity, infinity, 0},
      {elementary::atanh, -0.0, -0.0, 0},
      {elementary::atanh, -1.0, -infinity, ERANGE},
      {elementary::atanh, 1.5, not_a_number, EDOM},
  };
  for (const Case& one : cases) {
    errno = 0;
    expect_same(one.function(one.x), one.wanted, one.x);
    EXPECT_EQ(errno, one.error) << "of " << one.x << " that gives " << one.wanted;
  }
}

TEST(SpecialValues, OfNoNumberAreNoNumberAndNoError) {
  const std::vector<double (*)(double)> all{
      elementary::sin,  elementary::cos,   elementary::tan,   elementary::asin,  elementary::acos,
      elementary::atan, elementary::exp,   elementary::exp2,  elementary::expm1, elementary::log,
      elementary::log2, elementary::log10, elementary::log1p, elementary::sinh,  elementary::cosh,
      elementary::tanh, elementary::asinh, elementary::acosh, elementary::atanh};
  errno = 0;
  for (const auto function : all) EXPECT_TRUE(std::isnan(function(not_a_number)));
  EXPECT_EQ(errno, 0);
}

TEST(SpecialValues, OfPowersAreThoseOfTheStandard) {
  struct PowerCase {
    double x;
    double y;
    double wanted;
    int error;
  };
  const std::vector<PowerCase> cases{
      {not_a_number, 0.0, 1.0, 0},
      {1.0, not_a_number, 1.0, 0},
      {2.0, not_a_number, not_a_number, 0},
      {-1.0, infinity, 1.0, 0},
      {0.5, infinity, 0.0, 0},
      {0.5, -infinity, infinity, 0},
      {-2.0, infinity, infinity, 0},
      {0.0, infinity, 0.0, 0},
      {0.0, -infinity, infinity, 0},
      {-0.0, 3.0, -0.0, 0},
      {-0.0, 2.0, 0.0, 0},
      {-0.0, 0.5, 0.0, 0},
      {-0.0, -3.0, -infinity, ERANGE},
      {0.0, -0.5, infinity, ERANGE},
      {-infinity, 3.0, -infinity, 0},
      {-infinity, -3.0, -0.0, 0},
      {-infinity, 0.5, infinity, 0},
      {infinity, -1e-9, 0.0, 0},
      {-8.0, 1.0 / 3.0, not_a_number, EDOM},
      {-2.0, 3.0, -8.0, 0},
      {-2.0, -1.0, -0.5, 0},
      {-2.0, 1025.0, -infinity, ERANGE},
      {-2.0, -1075.5, not_a_number, EDOM},
      {-2.0, -1077.0, -0.0, ERANGE},
      {1.0000000000000002, 1e300, infinity, ERANGE},
      {0.9999999999999999, 1e300, 0.0, ERANGE},
      {5.0, 1e-300, 1.0, 0},
      {-1.0, 9007199254740991.0, -1.0, 0},
      {-1.0, 9007199254740992.0, 1.0, 0},
  };
  for (const PowerCase& one : cases) {
    errno = 0;
    expect_same(elementary::pow(one.x, one.y), one.wanted, one.x, one.y);
    EXPECT_EQ(errno, one.error) << one.x << ' ' << one.y;
  }
}

TEST(SpecialValues, OfTwoArgumentsOfAnAngleAreThoseOfTheStandard) {
  struct AngleCase {
    double y;
    double x;
    double wanted;
  };
  const std::vector<AngleCase> cases{{0.0, 0.0, 0.0},
                                     {0.0, -0.0, pi},
                                     {-0.0, -0.0, -pi},
                                     {-0.0, 1.0, -0.0},
                                     {-0.0, -1.0, -pi},
                                     {1.0, 0.0, pi / 2},
                                     {-1.0, -0.0, -pi / 2},
                                     {infinity, 1.0, pi / 2},
                                     {-1.0, infinity, -0.0},
                                     {1.0, -infinity, pi},
                                     {infinity, infinity, pi / 4},
                                     {-infinity, -infinity, -3 * pi / 4},
                                     {not_a_number, 1.0, not_a_number},
                                     {1.0, not_a_number, not_a_number},
                                     {1e-300, -1e300, pi},
                                     {1e300, 1e-300, pi / 2},
                                     {1e-300, 1e300, 0.0},
                                     {5e-324, 5e-324, pi / 4},
                                     {-1.7e308, 1.7e308, -pi / 4}};
  for (const AngleCase& one : cases) expect_same(elementary::atan2(one.y, one.x), one.wanted, one.y, one.x);
}

}  // namespace
}  // namespace floeplan::elementary::special_values_test
