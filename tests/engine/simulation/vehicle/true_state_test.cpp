#include "engine/simulation/vehicle/true_state.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/property.hpp"

namespace floeplan::simulation::true_state_test {
namespace {

using support::for_each_seed;
using support::uniform;

constexpr double right_angle = 0.5 * std::numbers::pi;

void expect_near(Vector a, Vector b) {
  EXPECT_NEAR(a.east, b.east, 1e-12);
  EXPECT_NEAR(a.north, b.north, 1e-12);
  EXPECT_NEAR(a.down, b.down, 1e-12);
}

TEST(BodyAxes, TurnClockwiseWithTheHeading) {
  const BodyAxes axes{{.heading_rad = right_angle}};

  expect_near(axes.forward(), {1.0, 0.0, 0.0});
  expect_near(axes.starboard(), {0.0, -1.0, 0.0});
}

TEST(BodyAxes, RaiseTheNoseWithThePitch) {
  expect_near(BodyAxes{{.pitch_rad = right_angle}}.forward(), {0.0, 0.0, -1.0});
}

TEST(BodyAxes, LowerTheStarboardSideWithTheRoll) {
  expect_near(BodyAxes{{.roll_rad = right_angle}}.starboard(), {0.0, 0.0, 1.0});
}

TEST(BodyAxes, StayAtRightAngles) {
  for_each_seed(100, [](std::mt19937_64& rng) {
    const BodyAxes axes{{uniform(rng, -4.0, 4.0), uniform(rng, -1.5, 1.5), uniform(rng, -3.0, 3.0)}};

    EXPECT_NEAR(dot(axes.forward(), axes.starboard()), 0.0, 1e-12);
    EXPECT_NEAR(dot(axes.forward(), axes.down()), 0.0, 1e-12);
    EXPECT_NEAR(dot(axes.starboard(), axes.down()), 0.0, 1e-12);
    EXPECT_NEAR(length(axes.to_frame(2.0, 3.0, 6.0)), 7.0, 1e-12);
  });
}

}  // namespace
}  // namespace floeplan::simulation::true_state_test
