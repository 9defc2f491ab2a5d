#include "engine/motion/runge_kutta.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace floeplan::motion::runge_kutta_test {
namespace {

/// dt/ds = t: the exact gain over h from t = 1 is e^h - 1.
tl::expected<double, EdgeClosed> exponential(double, double t) { return t; }

template <class Step>
double error_of_step(double h) {
  return std::abs(Step::step(exponential, 0.0, 1.0, h, 1.0)->gain - std::expm1(h));
}

template <class Step>
double error_between(double h) {
  const auto step = Step::step(exponential, 0.0, 1.0, h, 1.0);
  double worst = 0.0;
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    worst = std::max(worst, std::abs(step->gain_at(share) - std::expm1(share * h)));
  }
  return worst;
}

/// The power of the step with which an error falls, from the errors at two steps.
double order(double error, double error_of_half) { return std::log2(error / error_of_half); }

TEST(RungeKutta, StepsHaveTheOrderOfTheirFormula) {
  EXPECT_NEAR(order(error_of_step<BogackiShampine>(0.02), error_of_step<BogackiShampine>(0.01)), 5.0, 0.1);
  EXPECT_NEAR(order(error_of_step<DormandPrince>(0.2), error_of_step<DormandPrince>(0.1)), 6.0, 0.3);
}

TEST(RungeKutta, StepsOfThirdOrderAreAsGoodBetweenTheirEnds) {
  EXPECT_NEAR(order(error_between<BogackiShampine>(0.02), error_between<BogackiShampine>(0.01)), 4.0, 0.1);
}

TEST(RungeKutta, StepsEstimateMoreThanTheirError) {
  EXPECT_GT(BogackiShampine::step(exponential, 0.0, 1.0, 0.1, 1.0)->error,
            error_of_step<BogackiShampine>(0.1));
  EXPECT_GT(DormandPrince::step(exponential, 0.0, 1.0, 0.1, 1.0)->error, error_of_step<DormandPrince>(0.1));
}

TEST(RungeKutta, StepsFindTheShareOfAGain) {
  const auto step = DormandPrince::step(exponential, 0.0, 1.0, 0.8, 1.0);
  for (const double share : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    EXPECT_NEAR(share_with_gain(*step, step->gain_at(share)), share, 1e-12);
  }
}

}  // namespace
}  // namespace floeplan::motion::runge_kutta_test
