#include "engine/ocean/ice/iceberg_wind.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/property.hpp"

namespace floeplan::ocean::iceberg_wind_test {
namespace {

constexpr double windage = 0.0187;
constexpr double deg = std::numbers::pi / 180.0;

/// The number that the source calls Lambda.
double lambda_of(double wind_m_s, double length_m, double latitude_deg) {
  const double coriolis = 2.0 * 7.292115e-5 * std::abs(std::sin(latitude_deg * deg));
  return windage * 0.9 * wind_m_s / (std::numbers::pi * coriolis * length_m / 2.62);
}

TEST(IcebergWind, IsThePrintedAlphaAndBetaOfTheSource) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const double latitude_deg = support::uniform(rng, 20.0, 89.0);
    const double length_m = support::uniform(rng, 50.0, 5000.0);
    const double wind_m_s = support::uniform(rng, 2.0, 25.0);
    const double lambda = lambda_of(wind_m_s, length_m, latitude_deg);
    if (lambda < 0.1 || lambda > 10.0) return;  // beyond it the printed form loses its digits

    const auto drift = moved_by_wind({{0.0}, {wind_m_s}}, core::Metres{length_m}, latitude_deg);

    const double l3 = std::pow(lambda, 3);
    const double l4 = std::pow(lambda, 4);
    const double root = std::sqrt(1.0 + 4.0 * l4);
    const double alpha = (root - 1.0) / (2.0 * l3);
    const double beta = std::sqrt((1.0 + l4) * root - 3.0 * l4 - 1.0) / (std::numbers::sqrt2 * l3);
    EXPECT_NEAR(drift.east.value, windage * wind_m_s * alpha, 1e-6);
    EXPECT_NEAR(drift.north.value, windage * wind_m_s * beta, 1e-6);
  });
}

TEST(IcebergWind, TurnsByFiftyTwoDegreesWhereDragAndCoriolisForceAreAlike) {
  // Source: Wagner, Dell and Eisenman 2017: alpha 0.618 and beta 0.486 where Lambda is 1.
  const double length_m = 800.0;
  const double wind_m_s = 1.0 / lambda_of(1.0, length_m, 70.0);

  const auto north = moved_by_wind({{0.0}, {wind_m_s}}, core::Metres{length_m}, 70.0);
  const auto south = moved_by_wind({{0.0}, {wind_m_s}}, core::Metres{length_m}, -70.0);

  EXPECT_NEAR(north.east.value / (windage * wind_m_s), 0.618, 5e-4);
  EXPECT_NEAR(north.north.value / (windage * wind_m_s), 0.486, 5e-4);
  EXPECT_NEAR(std::atan2(north.east.value, north.north.value) / deg, 52.0, 0.5);
  EXPECT_EQ(south.east, -1.0 * north.east);
  EXPECT_EQ(south.north, north.north);
}

TEST(IcebergWind, DrivesSmallOnesBeforeItAtTwoPercent) {
  const auto drift = moved_by_wind({{6.0}, {8.0}}, core::Metres{10.0}, 65.0);

  EXPECT_NEAR(geo::strength(drift).value, 0.187, 1e-3);
  EXPECT_NEAR(drift.east.value / drift.north.value, 0.75, 0.03);
}

TEST(IcebergWind, NeverMovesThemFasterThanTheWindageAndLargeOnesLess) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const geo::VelocityEn wind{{support::uniform(rng, -20.0, 20.0)}, {support::uniform(rng, -20.0, 20.0)}};
    const double latitude_deg = support::uniform(rng, -90.0, 90.0);
    const double length_m = support::uniform(rng, 5.0, 3000.0);

    const double small = geo::strength(moved_by_wind(wind, core::Metres{length_m}, latitude_deg)).value;
    const double large = geo::strength(moved_by_wind(wind, core::Metres{2.0 * length_m}, latitude_deg)).value;

    EXPECT_LE(small, windage * geo::strength(wind).value * (1.0 + 1e-12));
    EXPECT_LE(large, small * (1.0 + 1e-12));
  });
}

TEST(IcebergWind, DoesNothingWhenItIsCalmAndGoesStraightAtTheEquator) {
  EXPECT_EQ(moved_by_wind({}, core::Metres{100.0}, 70.0), geo::VelocityEn{});
  const auto equator = moved_by_wind({{10.0}, {0.0}}, core::Metres{100.0}, 0.0);
  EXPECT_NEAR(equator.east.value, 0.187, 1e-12);
  EXPECT_EQ(equator.north.value, 0.0);
}

}  // namespace
}  // namespace floeplan::ocean::iceberg_wind_test
