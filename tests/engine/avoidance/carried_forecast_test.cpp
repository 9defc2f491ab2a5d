#include "engine/avoidance/carried_forecast.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace floeplan::avoidance::carried_forecast_test {
namespace {

core::UtcTime at_s(double seconds) { return core::from_unix_seconds(seconds); }

/// Linear in place, depth and time, which linear interpolation reproduces.
geo::VelocityEn plane(double x, double y, double z, double t) {
  return {{0.1 + 1e-4 * x + 2e-3 * z}, {-1e-4 * y + 1e-5 * t}};
}

CarriedForecast::Grid linear_grid() {
  CarriedForecast::Grid grid{
      .origin = {-500.0, -500.0}, .spacing = core::Metres{500.0}, .columns = 4, .rows = 3};
  grid.depths = {core::Metres{0.0}, core::Metres{50.0}};
  grid.times = {at_s(0.0), at_s(3600.0)};
  for (const core::UtcTime time : grid.times) {
    for (const core::Metres depth : grid.depths) {
      for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
          grid.values.push_back(
              plane(-500.0 + 500.0 * column, -500.0 + 500.0 * row, depth.value, core::unix_seconds(time)));
        }
      }
    }
  }
  return grid;
}

TEST(CarriedForecast, IsLinearBetweenItsPoints) {
  const CarriedForecast forecast{linear_grid()};
  const geo::VelocityEn found = forecast.at({130.0, -270.0}, core::Metres{20.0}, at_s(900.0));
  const geo::VelocityEn expected = plane(130.0, -270.0, 20.0, 900.0);
  EXPECT_NEAR(found.east.value, expected.east.value, 1e-12);
  EXPECT_NEAR(found.north.value, expected.north.value, 1e-12);
}

TEST(CarriedForecast, HoldsItsNearestValueOutside) {
  const CarriedForecast forecast{linear_grid()};
  const geo::VelocityEn corner = plane(1000.0, 500.0, 50.0, 3600.0);
  const geo::VelocityEn found = forecast.at({9e5, 9e5}, core::Metres{900.0}, at_s(1e6));
  EXPECT_NEAR(found.east.value, corner.east.value, 1e-12);
  EXPECT_NEAR(found.north.value, corner.north.value, 1e-12);
}

TEST(CarriedForecast, RefusesAGridThatIsNotWhole) {
  CarriedForecast::Grid missing = linear_grid();
  missing.values.pop_back();
  EXPECT_THROW(CarriedForecast{missing}, std::invalid_argument);

  CarriedForecast::Grid falling = linear_grid();
  std::swap(falling.times[0], falling.times[1]);
  EXPECT_THROW(CarriedForecast{falling}, std::invalid_argument);

  CarriedForecast::Grid not_finite = linear_grid();
  not_finite.values[3].north.value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CarriedForecast{not_finite}, std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::avoidance::carried_forecast_test
