#include "engine/avoidance/current_estimate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/core/random.hpp"
#include "tests/support/property.hpp"

namespace floeplan::avoidance::current_estimate_test {
namespace {

constexpr core::Metres deepest{200.0};
constexpr core::MetresPerSecond forecast_sigma{0.1};

core::UtcTime at_s(double seconds) { return core::from_unix_seconds(seconds); }

CurrentBin bin(double depth_m, double east, double north, double sigma) {
  return {core::Metres{depth_m}, {{east}, {north}}, core::MetresPerSecond{sigma}};
}

TEST(CurrentEstimate, IsTheForecastWithItsErrorBeforeAnyProfile) {
  const CarriedForecast forecast{geo::VelocityEn{{0.2}, {-0.1}}};
  const CurrentEstimate estimate{forecast, deepest, forecast_sigma};
  const EstimatedCurrent found = estimate.at({}, core::Metres{0.0}, at_s(0.0));
  EXPECT_DOUBLE_EQ(found.velocity.east.value, 0.2);
  EXPECT_DOUBLE_EQ(found.velocity.north.value, -0.1);
  EXPECT_NEAR(found.one_sigma.value, 0.1, 1e-12);
}

TEST(CurrentEstimate, WeighsForecastAndMeasurementByTheirVariances) {
  const CarriedForecast forecast{geo::VelocityEn{}};
  CurrentEstimate estimate{forecast, deepest, forecast_sigma};
  const std::array bins{bin(0.0, 0.1, 0.0, 0.05)};

  estimate.take({at_s(0.0), bins}, {});

  const EstimatedCurrent found = estimate.at({}, core::Metres{0.0}, at_s(0.0));
  EXPECT_NEAR(found.velocity.east.value, 0.1 * 0.01 / (0.01 + 0.0025), 1e-12);
  EXPECT_NEAR(found.one_sigma.value, std::sqrt(1.0 / (1.0 / 0.01 + 1.0 / 0.0025)), 1e-12);
}

TEST(CurrentEstimate, TellsLessOfOtherDepthsAndOfLaterTimes) {
  const CarriedForecast forecast{geo::VelocityEn{}};
  CurrentEstimate estimate{forecast, deepest, forecast_sigma};
  const std::array bins{bin(0.0, 0.1, 0.0, 0.02)};
  estimate.take({at_s(0.0), bins}, {});

  const double here = estimate.at({}, core::Metres{0.0}, at_s(0.0)).velocity.east.value;
  const double deeper = estimate.at({}, core::Metres{100.0}, at_s(0.0)).velocity.east.value;
  const double later = estimate.at({}, core::Metres{0.0}, at_s(6.0 * 3600.0)).velocity.east.value;
  EXPECT_NEAR(deeper, here * std::exp(-100.0 / 50.0), 0.01 * here);
  EXPECT_NEAR(later, here * std::exp(-1.0), 1e-12);
  EXPECT_NEAR(estimate.at({}, core::Metres{0.0}, at_s(1e7)).one_sigma.value, 0.1, 1e-9);
}

TEST(CurrentEstimate, LeavesOutWhatCannotBeAMeasurement) {
  const CarriedForecast forecast{geo::VelocityEn{}};
  CurrentEstimate estimate{forecast, deepest, forecast_sigma};
  const std::array bins{bin(10.0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.02),
                        bin(10.0, 0.1, 0.0, 0.0), bin(10.0, 5.0, 0.0, 0.02)};
  estimate.take({at_s(0.0), bins}, {});
  EXPECT_EQ(estimate.at({}, core::Metres{10.0}, at_s(0.0)).velocity.east.value, 0.0);
}

/// Law: if the current follows the process that the filter assumes, the errors are as large as the filter
/// states.
TEST(CurrentEstimate, StatesItsOwnErrorTruly) {
  const CarriedForecast forecast{geo::VelocityEn{}};
  double squares = 0.0;
  int count = 0;
  support::for_each_seed(400, [&](std::mt19937_64& rng) {
    const double truth = 0.1 * core::normal(rng);
    CurrentEstimate estimate{forecast, deepest, forecast_sigma};
    for (int i = 0; i < 5; ++i) {
      const std::array bins{bin(0.0, truth + 0.05 * core::normal(rng), 0.0, 0.05)};
      estimate.take({at_s(0.0), bins}, {});
    }
    const EstimatedCurrent found = estimate.at({}, core::Metres{0.0}, at_s(0.0));
    squares += std::pow((found.velocity.east.value - truth) / found.one_sigma.value, 2);
    ++count;
  });
  EXPECT_NEAR(squares / count, 1.0, 0.25);  // chi-squared of 400: sigma 0.07
}

}  // namespace
}  // namespace floeplan::avoidance::current_estimate_test
