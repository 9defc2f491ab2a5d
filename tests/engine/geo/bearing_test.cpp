#include "engine/geo/bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/property.hpp"

namespace floeplan::geo::bearing_test {
namespace {

TEST(Bearing, TurnsClockwiseFromNorth) {
  EXPECT_NEAR(Bearing::degrees(90.0).east(), 1.0, 1e-15);
  EXPECT_NEAR(Bearing::degrees(180.0).north(), -1.0, 1e-15);
  EXPECT_NEAR(Bearing::towards(-1.0, 0.0).degrees(), 270.0, 1e-12);
}

TEST(Bearing, IsNorthWithoutADirection) { EXPECT_EQ(Bearing::towards(0.0, 0.0).degrees(), 0.0); }

TEST(Bearing, ComesBackInsideOneTurn) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const double angle_deg = support::uniform(rng, -720.0, 720.0);
    const double back_deg = Bearing::degrees(angle_deg).degrees();

    EXPECT_GE(back_deg, 0.0);
    EXPECT_LT(back_deg, 360.0);
    EXPECT_NEAR(std::remainder(back_deg - angle_deg, 360.0), 0.0, 1e-9);
  });
}

TEST(Bearing, OfNorthIsZeroAndNeverMinusZero) {
  EXPECT_FALSE(std::signbit(Bearing::towards(-0.0, 1.0).degrees()));
}

TEST(Bearing, IsNamedByTheNearestPointOfTheCompass) {
  EXPECT_EQ(compass_point(Bearing::degrees(359.0)), "north");
  EXPECT_EQ(compass_point(Bearing::degrees(22.0)), "north");
  EXPECT_EQ(compass_point(Bearing::degrees(23.0)), "north-east");
  EXPECT_EQ(compass_point(Bearing::degrees(180.0)), "south");
  EXPECT_EQ(compass_point(Bearing::towards(-1.0, 1.0)), "north-west");
}

}  // namespace
}  // namespace floeplan::geo::bearing_test
