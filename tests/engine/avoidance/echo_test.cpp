#include "engine/avoidance/echo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/avoidance/water_frame.hpp"

namespace floeplan::avoidance::echo_test {
namespace {

Attitude attitude(double heading_deg, double pitch_deg, double roll_deg) {
  return {core::Radians{core::degrees_to_radians(heading_deg)},
          core::Radians{core::degrees_to_radians(pitch_deg)},
          core::Radians{core::degrees_to_radians(roll_deg)}};
}

void expect_vector(const LevelVector& found, double east, double north, double down) {
  EXPECT_NEAR(found.east, east, 1e-12);
  EXPECT_NEAR(found.north, north, 1e-12);
  EXPECT_NEAR(found.down, down, 1e-12);
}

TEST(Echo, AheadOfAVehicleThatHeadsEastLiesEast) {
  expect_vector(levelled({1.0, 0.0, 0.0}, attitude(90.0, 0.0, 0.0)), 1.0, 0.0, 0.0);
  expect_vector(levelled({0.0, 1.0, 0.0}, attitude(90.0, 0.0, 0.0)), 0.0, -1.0, 0.0);
}

TEST(Echo, NoseUpLooksUp) {
  expect_vector(levelled({1.0, 0.0, 0.0}, attitude(0.0, 90.0, 0.0)), 0.0, 0.0, -1.0);
}

TEST(Echo, StarboardSideDownLooksDownThere) {
  expect_vector(levelled({0.0, 1.0, 0.0}, attitude(0.0, 0.0, 90.0)), 0.0, 0.0, 1.0);
}

TEST(Echo, OfNoUseIsRefused) {
  const core::Metres reach{200.0};
  EXPECT_TRUE(is_usable({core::Metres{10.0}, {1.0, 0.0, 0.0}, 80.0}, reach));
  EXPECT_FALSE(is_usable({core::Metres{0.0}, {1.0, 0.0, 0.0}, 80.0}, reach));
  EXPECT_FALSE(is_usable({core::Metres{201.0}, {1.0, 0.0, 0.0}, 80.0}, reach));
  EXPECT_FALSE(is_usable({core::Metres{10.0}, {std::nan(""), 0.0, 0.0}, 80.0}, reach));
  EXPECT_FALSE(
      is_usable({core::Metres{std::numeric_limits<double>::infinity()}, {1.0, 0.0, 0.0}, 80.0}, reach));
}

SonarReturn seen_at(double elevation_deg, double range_m) {
  const double elevation = core::degrees_to_radians(elevation_deg);
  return {core::Metres{range_m}, {std::cos(elevation), 0.0, -std::sin(elevation)}, 80.0};
}

TEST(Echo, MayComeFromAnywhereWithinTheHeightOfItsBeam) {
  SonarView view;
  view.beam_half_height = core::Radians{core::degrees_to_radians(10.0)};
  view.edge = core::Radians{core::degrees_to_radians(25.0)};
  view.edge_half_height = core::Radians{core::degrees_to_radians(18.0)};
  OwnState own;
  own.depth = core::Metres{20.0};
  const auto below_own_m = [](double range_m, double down_deg) {
    return 20.0 + range_m * std::sin(core::degrees_to_radians(down_deg));
  };

  const Echo inner = placed(seen_at(15.0, 100.0), own, {}, view);
  EXPECT_NEAR(inner.depth_m, below_own_m(100.0, -15.0), 1e-9);
  EXPECT_NEAR(inner.shallowest_m, below_own_m(100.0, -25.0), 1e-9);
  EXPECT_NEAR(inner.deepest_m, below_own_m(100.0, -5.0), 1e-9);

  own.attitude = attitude(0.0, 26.0, 0.0);
  const Echo lowest = placed(seen_at(-30.0, 100.0), own, {}, view);
  EXPECT_NEAR(lowest.shallowest_m, below_own_m(100.0, -6.0), 1e-9);
  EXPECT_NEAR(lowest.deepest_m, below_own_m(100.0, 22.0), 1e-9);

  own.attitude = attitude(0.0, -70.0, 0.0);
  const Echo down = placed(seen_at(-30.0, 100.0), own, {}, view);
  EXPECT_NEAR(down.deepest_m, 120.0, 1e-9);
}

/// A fix that corrects the position by a kilometre does not move objects in the frame of the water.
TEST(WaterFrame, KeepsWhatWasSeenWhereItWasWhenAFixComes) {
  WaterFrame water;
  OwnState own;
  own.attitude = attitude(90.0, 0.0, 0.0);
  own.through_water = core::MetresPerSecond{0.5};
  own.time = core::from_unix_seconds(0.0);
  water.step(own);
  own.time = core::from_unix_seconds(10.0);
  own.place = {-3.0, 1000.0};
  water.step(own);

  EXPECT_NEAR(water.own().x_m, 5.0, 1e-12);
  EXPECT_NEAR(water.own().y_m, 0.0, 1e-12);
  EXPECT_NEAR(water.from_local(own.place).x_m, 5.0, 1e-12);
  EXPECT_NEAR(water.to_local(water.own()).y_m, 1000.0, 1e-12);
}

}  // namespace
}  // namespace floeplan::avoidance::echo_test
