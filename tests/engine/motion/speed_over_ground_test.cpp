#include "engine/motion/speed_over_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/property.hpp"

namespace floeplan::motion::speed_over_ground_test {
namespace {

using core::MetresPerSecond;
using geo::Bearing;
using geo::VelocityEn;

constexpr MetresPerSecond glider{0.35};

VelocityEn random_velocity(std::mt19937_64& rng, MetresPerSecond largest) {
  const Bearing towards = Bearing::degrees(support::uniform(rng, 0.0, 360.0));
  const double speed = support::uniform(rng, 0.0, largest.value);
  return {{speed * towards.east()}, {speed * towards.north()}};
}

TEST(SpeedOverGround, AddsACurrentAlongTheCourseAndTakesOffOneAgainstIt) {
  const VelocityEn eastward{{0.1}, {0.0}};

  EXPECT_NEAR(speed_over_ground(glider, eastward, Bearing::degrees(90.0))->value, 0.45, 1e-12);
  EXPECT_NEAR(speed_over_ground(glider, eastward, Bearing::degrees(270.0))->value, 0.25, 1e-12);
}

TEST(SpeedOverGround, IsTheOtherSideOfTheTriangleInACrossCurrent) {
  const VelocityEn northward{{0.0}, {0.3}};

  EXPECT_NEAR(speed_over_ground(MetresPerSecond{0.5}, northward, Bearing::degrees(90.0))->value, 0.4, 1e-12);
}

TEST(SpeedOverGround, IsRefusedWhenTheCrossCurrentBeatsTheGlider) {
  const VelocityEn northward{{0.0}, {0.4}};

  const auto speed = speed_over_ground(glider, northward, Bearing::degrees(90.0));

  ASSERT_FALSE(speed.has_value());
  EXPECT_EQ(speed.error(), EdgeClosed::current_too_strong);
}

TEST(SpeedOverGround, IsRefusedWhenTheCurrentCarriesTheGliderBackwards) {
  const auto speed = speed_over_ground(glider, VelocityEn{{-0.36}, {0.0}}, Bearing::degrees(90.0));

  ASSERT_FALSE(speed.has_value());
  EXPECT_EQ(speed.error(), EdgeClosed::current_too_strong);
}

TEST(SpeedOverGround, StaysWithinSumAndDifferenceOfTheTwoSpeeds) {
  support::for_each_seed(1000, [](std::mt19937_64& rng) {
    const VelocityEn current = random_velocity(rng, MetresPerSecond{0.3});
    const Bearing course = Bearing::degrees(support::uniform(rng, 0.0, 360.0));

    const auto speed = speed_over_ground(glider, current, course);

    ASSERT_TRUE(speed.has_value());
    EXPECT_NEAR(speed->value, glider.value, strength(current).value + 1e-12);
  });
}

TEST(SpeedOverGround, LeavesTheGliderItsOwnSpeedThroughTheWater) {
  support::for_each_seed(1000, [](std::mt19937_64& rng) {
    const VelocityEn current = random_velocity(rng, MetresPerSecond{0.6});
    const Bearing course = Bearing::degrees(support::uniform(rng, 0.0, 360.0));

    const auto speed = speed_over_ground(glider, current, course);
    if (!speed) return;

    const double through_east = speed->value * course.east() - current.east.value;
    const double through_north = speed->value * course.north() - current.north.value;
    EXPECT_NEAR(std::hypot(through_east, through_north), glider.value, 1e-12);
  });
}

}  // namespace
}  // namespace floeplan::motion::speed_over_ground_test
