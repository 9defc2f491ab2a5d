#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "engine/elementary/elementary.hpp"
#include "tests/support/property.hpp"

namespace floeplan::elementary::accuracy_test {

// GCC's own library for 113 bits; its header is not one of ISO C++.
__extension__ using Quad = __float128;
extern "C" {
Quad sinq(Quad);
Quad cosq(Quad);
Quad tanq(Quad);
Quad asinq(Quad);
Quad acosq(Quad);
Quad atanq(Quad);
Quad atan2q(Quad, Quad);
Quad expq(Quad);
Quad exp2q(Quad);
Quad expm1q(Quad);
Quad powq(Quad, Quad);
Quad logq(Quad);
Quad log2q(Quad);
Quad log10q(Quad);
Quad log1pq(Quad);
Quad sinhq(Quad);
Quad coshq(Quad);
Quad tanhq(Quad);
Quad asinhq(Quad);
Quad acoshq(Quad);
Quad atanhq(Quad);
}

namespace {

using support::for_each_seed;
using support::uniform;

constexpr double sharp = 0.56;   // units in the last place, as the header has it
constexpr double of_sine = 0.8;  // sin, cos
constexpr double of_tangent = 1.0;
constexpr double subnormal = 0.76;  // rounded twice: first to 53 bits
constexpr int draws = 200;          // for each seed

double last_place(double x) {
  const double size = std::max(std::abs(x), std::numeric_limits<double>::min());
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

/// How far `value` is from `exact`, in units of the last place of the result; of a result beyond all doubles: whether it
/// is the infinity.
double error_of(double value, Quad exact) {
  const double nearest = static_cast<double>(exact);
  if (!std::isfinite(nearest) || !std::isfinite(value)) {
    return value == nearest ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return std::abs(static_cast<double>((static_cast<Quad>(value) - exact) / last_place(nearest)));
}

double any_finite(std::mt19937_64& rng) {
  for (;;) {
    const double x = std::bit_cast<double>(rng());
    if (std::isfinite(x)) return x;
  }
}

/// A number of either sign whose size lies between 2^low and 2^high, each power of two equally likely.
double of_any_size(std::mt19937_64& rng, double low, double high) {
  const double size = std::exp2(uniform(rng, low, high));
  return rng() % 2 == 0 ? size : -size;
}

template <class Function, class Exact, class Draw>
void expect_within(double bound, const Function& function, const Exact& exact, const Draw& draw) {
  for_each_seed(30, [&](std::mt19937_64& rng) {
    for (int i = 0; i < draws; ++i) {
      const double x = draw(rng);
      const double value = function(x);
      const Quad wanted = exact(static_cast<Quad>(x));
      const bool small = std::abs(value) < std::numeric_limits<double>::min();
      ASSERT_LE(error_of(value, wanted), small ? std::max(subnormal, bound) : bound) << std::hexfloat << x;
    }
  });
}

template <class Function, class Exact, class Draw>
void expect_within(double bound, const Function& function, const Exact& exact, const Draw& draw_x,
                   const Draw& draw_y) {
  for_each_seed(30, [&](std::mt19937_64& rng) {
    for (int i = 0; i < draws; ++i) {
      const double x = draw_x(rng);
      const double y = draw_y(rng);
      const double value = function(x, y);
      const Quad wanted = exact(static_cast<Quad>(x), static_cast<Quad>(y));
      const bool small = std::abs(value) < std::numeric_limits<double>::min();
      ASSERT_LE(error_of(value, wanted), small ? std::max(subnormal, bound) : bound)
          << std::hexfloat << x << ' ' << y;
    }
  });
}

/// Draws arguments.
using Draw = double (*)(std::mt19937_64&);

constexpr Draw angle = [](std::mt19937_64& rng) { return uniform(rng, -10.0, 10.0); };
constexpr Draw within_a_million = [](std::mt19937_64& rng) { return uniform(rng, -2e6, 2e6); };
constexpr Draw angle_of_any_size = [](std::mt19937_64& rng) { return of_any_size(rng, -1074.0, 1024.0); };
/// The doubles nearest to multiples of a quarter turn, where all leading digits cancel.
constexpr Draw quarter_turn = [](std::mt19937_64& rng) {
  return std::rint(of_any_size(rng, 0.0, 60.0)) * 1.5707963267948966;
};
constexpr Draw unit = [](std::mt19937_64& rng) { return uniform(rng, -1.0, 1.0); };
constexpr Draw unit_of_any_size = [](std::mt19937_64& rng) { return of_any_size(rng, -1074.0, 0.0); };
constexpr Draw near_one = [](std::mt19937_64& rng) { return 1.0 - std::exp2(uniform(rng, -53.0, -1.0)); };
constexpr Draw exponent = [](std::mt19937_64& rng) { return uniform(rng, -760.0, 720.0); };
constexpr Draw exponent_of_any_size = [](std::mt19937_64& rng) { return of_any_size(rng, -100.0, 9.6); };
constexpr Draw exponent_of_two = [](std::mt19937_64& rng) { return uniform(rng, -1080.0, 1030.0); };
constexpr Draw positive = [](std::mt19937_64& rng) { return uniform(rng, 0.0, 3.0); };
constexpr Draw about_one = [](std::mt19937_64& rng) { return 1.0 + of_any_size(rng, -53.0, -1.0); };
constexpr Draw positive_of_any_size = [](std::mt19937_64& rng) {
  return std::max(std::exp2(uniform(rng, -1074.0, 1024.0)), std::numeric_limits<double>::denorm_min());
};
constexpr Draw above_one = [](std::mt19937_64& rng) { return 1.0 + std::exp2(uniform(rng, -52.0, 1020.0)); };

TEST(Sine, IsAsExactAsStated) {
  for (const Draw draw : {angle, within_a_million, angle_of_any_size, quarter_turn, Draw{any_finite}})
    expect_within(of_sine, [](double x) { return elementary::sin(x); }, sinq, draw);
}
TEST(Cosine, IsAsExactAsStated) {
  for (const Draw draw : {angle, within_a_million, angle_of_any_size, quarter_turn, Draw{any_finite}})
    expect_within(of_sine, [](double x) { return elementary::cos(x); }, cosq, draw);
}
TEST(Tangent, IsAsExactAsStated) {
  for (const Draw draw : {angle, within_a_million, angle_of_any_size, quarter_turn, Draw{any_finite}})
    expect_within(of_tangent, [](double x) { return elementary::tan(x); }, tanq, draw);
}
TEST(SineAndCosine, HaveTheBitsOfBoth) {
  for_each_seed(100, [](std::mt19937_64& rng) {
    for (const Draw draw : {angle, within_a_million, angle_of_any_size, quarter_turn}) {
      const double x = draw(rng);
      const SineCosine both = elementary::sincos(x);
      ASSERT_EQ(both.sine, elementary::sin(x)) << x;
      ASSERT_EQ(both.cosine, elementary::cos(x)) << x;
    }
  });
}

TEST(ArcSine, IsAsExactAsStated) {
  for (const Draw draw : {unit, unit_of_any_size, near_one})
    expect_within(sharp, [](double x) { return elementary::asin(x); }, asinq, draw);
}
TEST(ArcCosine, IsAsExactAsStated) {
  for (const Draw draw : {unit, unit_of_any_size, near_one})
    expect_within(sharp, [](double x) { return elementary::acos(x); }, acosq, draw);
}
TEST(ArcTangent, IsAsExactAsStated) {
  for (const Draw draw : {angle, angle_of_any_size})
    expect_within(sharp, [](double x) { return elementary::atan(x); }, atanq, draw);
  const auto ours = [](double y, double x) { return elementary::atan2(y, x); };
  expect_within(sharp, ours, atan2q, unit, unit);
  expect_within(sharp, ours, atan2q, angle_of_any_size, angle_of_any_size);
  expect_within(sharp, ours, atan2q, exponent_of_any_size, exponent_of_any_size);
}

TEST(Exponential, IsAsExactAsStated) {
  for (const Draw draw : {unit, exponent, exponent_of_any_size})
    expect_within(sharp, [](double x) { return elementary::exp(x); }, expq, draw);
  for (const Draw draw : {unit, exponent_of_two, exponent_of_any_size})
    expect_within(sharp, [](double x) { return elementary::exp2(x); }, exp2q, draw);
  for (const Draw draw : {unit, exponent, exponent_of_any_size})
    expect_within(sharp, [](double x) { return elementary::expm1(x); }, expm1q, draw);
}
TEST(Power, IsAsExactAsStated) {
  const auto ours = [](double x, double y) { return elementary::pow(x, y); };
  expect_within(sharp, ours, powq, positive, angle);
  expect_within(sharp, ours, powq, about_one, angle_of_any_size);
  expect_within(sharp, ours, powq, positive_of_any_size, exponent_of_any_size);
  const Draw whole = [](std::mt19937_64& rng) { return std::floor(uniform(rng, -30.0, 30.0)); };
  expect_within(sharp, ours, powq, angle, whole);
}
TEST(Logarithm, IsAsExactAsStated) {
  for (const Draw draw : {positive, about_one, positive_of_any_size}) {
    expect_within(sharp, [](double x) { return elementary::log(x); }, logq, draw);
    expect_within(sharp, [](double x) { return elementary::log2(x); }, log2q, draw);
    expect_within(sharp, [](double x) { return elementary::log10(x); }, log10q, draw);
    expect_within(sharp, [](double x) { return elementary::log1p(x); }, log1pq, draw);
  }
  for (const Draw draw : {unit, unit_of_any_size})
    expect_within(sharp, [](double x) { return elementary::log1p(x); }, log1pq, draw);
}

TEST(HyperbolicFunctions, AreAsExactAsStated) {
  for (const Draw draw : {unit, exponent, exponent_of_any_size}) {
    expect_within(sharp, [](double x) { return elementary::sinh(x); }, sinhq, draw);
    expect_within(sharp, [](double x) { return elementary::cosh(x); }, coshq, draw);
    expect_within(sharp, [](double x) { return elementary::tanh(x); }, tanhq, draw);
  }
  for (const Draw draw : {unit, angle, angle_of_any_size})
    expect_within(sharp, [](double x) { return elementary::asinh(x); }, asinhq, draw);
  expect_within(sharp, [](double x) { return elementary::acosh(x); }, acoshq, above_one);
  for (const Draw draw : {unit, unit_of_any_size, near_one})
    expect_within(sharp, [](double x) { return elementary::atanh(x); }, atanhq, draw);
}

TEST(ExactValues, AreReturned) {
  for (int n = 0; n <= 22; ++n) {
    double power = 1.0;
    for (int i = 0; i < n; ++i) power *= 10.0;
    EXPECT_EQ(elementary::pow(10.0, n), power) << n;
    EXPECT_EQ(elementary::log10(power), n);
  }
  for (int n = -1074; n <= 1023; ++n) {
    EXPECT_EQ(elementary::exp2(n), std::ldexp(1.0, n)) << n;
    EXPECT_EQ(elementary::pow(2.0, n), std::ldexp(1.0, n)) << n;
    EXPECT_EQ(elementary::log2(std::ldexp(1.0, n)), n);
  }
  for_each_seed(1000, [](std::mt19937_64& rng) {
    const double root = std::floor(uniform(rng, 1.0, 90e6));
    EXPECT_EQ(elementary::pow(root, 2.0), root * root);
    EXPECT_EQ(elementary::pow(root * root, 0.5), root);
  });
}

}  // namespace
}  // namespace floeplan::elementary::accuracy_test
