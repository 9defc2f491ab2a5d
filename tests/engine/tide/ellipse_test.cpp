#include "engine/tide/ellipse.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/units.hpp"
#include "tests/support/property.hpp"

namespace floeplan::tide::ellipse_test {
namespace {

using support::for_each_seed;
using support::uniform;

TEST(Ellipse, OfAnEastGoingTideLiesAlongEast) {
  const Ellipse ellipse = ellipse_of({std::polar(0.5, -1.0), 0.0});
  EXPECT_NEAR(ellipse.major, 0.5, 1e-12);
  EXPECT_NEAR(ellipse.minor, 0.0, 1e-12);
  EXPECT_NEAR(ellipse.inclination_deg, 0.0, 1e-9);
  EXPECT_NEAR(ellipse.phase_deg, core::radians_to_degrees(1.0), 1e-9);
}

TEST(Ellipse, ThatTurnsClockwiseHasANegativeMinorAxis) {
  // East first, a quarter of a period later south.
  const Ellipse ellipse = ellipse_of({{0.3, 0.0}, {0.0, 0.2}});
  EXPECT_NEAR(ellipse.major, 0.3, 1e-12);
  EXPECT_NEAR(ellipse.minor, -0.2, 1e-12);
}

TEST(Ellipse, AndConstantsAreTwoViewsOfOneCurrent) {
  for_each_seed(500, [](std::mt19937_64& rng) {
    const CurrentConstants constants{{uniform(rng, -1.0, 1.0), uniform(rng, -1.0, 1.0)},
                                     {uniform(rng, -1.0, 1.0), uniform(rng, -1.0, 1.0)}};
    const Ellipse ellipse = ellipse_of(constants);
    const CurrentConstants back = constants_of(ellipse);
    EXPECT_LT(std::abs(back.east - constants.east), 1e-12);
    EXPECT_LT(std::abs(back.north - constants.north), 1e-12);
    EXPECT_GE(ellipse.inclination_deg, 0.0);
    EXPECT_LT(ellipse.inclination_deg, 180.0);
    EXPECT_GE(ellipse.phase_deg, 0.0);
    EXPECT_LT(ellipse.phase_deg, 360.0);
    EXPECT_LE(std::abs(ellipse.minor), ellipse.major);
  });
}

TEST(Ellipse, ReachesItsMajorAxisAtItsPhase) {
  for_each_seed(200, [](std::mt19937_64& rng) {
    const Ellipse ellipse{1.0, uniform(rng, -0.9, 0.9), uniform(rng, 0.0, 180.0), uniform(rng, 0.0, 360.0)};
    const CurrentConstants constants = constants_of(ellipse);
    const auto then = std::polar(1.0, core::degrees_to_radians(ellipse.phase_deg));
    const double east = std::real(constants.east * then);
    const double north = std::real(constants.north * then);
    EXPECT_NEAR(east, std::cos(core::degrees_to_radians(ellipse.inclination_deg)), 1e-12);
    EXPECT_NEAR(north, std::sin(core::degrees_to_radians(ellipse.inclination_deg)), 1e-12);
  });
}

}  // namespace
}  // namespace floeplan::tide::ellipse_test
