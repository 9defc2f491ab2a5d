#include "storage/ingest/grids/true_north.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/property.hpp"

namespace floeplan::ingest::true_north_test {
namespace {

using support::for_each_seed;
using support::uniform;

constexpr double pi = std::numbers::pi;

GridDirections turned_by(double angle) {
  GridDirections directions;
  directions.add(angle);
  return directions;
}

TEST(TrueNorth, IsWhereACurrentAlongAFirstAxisThatPointsNorthRuns) {
  const EastNorth current = to_true_north(0.5, 0.0, turned_by(pi / 2.0), 0);

  EXPECT_NEAR(current.east, 0.0, 1e-7);
  EXPECT_NEAR(current.north, 0.5, 1e-7);
}

TEST(TrueNorth, LiesAlongTheSecondAxisOfAGridThatIsNotTurned) {
  const GridDirections directions = GridDirections::along_east(2);

  for (const std::size_t point : {std::size_t{0}, std::size_t{1}}) {
    const EastNorth current = to_true_north(-0.25, 0.75, directions, point);
    EXPECT_EQ(current.east, -0.25F);
    EXPECT_EQ(current.north, 0.75F);
  }
  EXPECT_EQ(directions.largest_turn_deg(), 0.0);
}

TEST(TrueNorth, OfAnUnknownDirectionIsThatOfAGridAlongEast) {
  GridDirections directions;
  directions.add(std::nullopt);

  EXPECT_EQ(to_true_north(0.1, 0.2, directions, 0).east, 0.1F);
}

TEST(TrueNorth, KeepsTheSpeedAndTurnsTheWholeAngle) {
  for_each_seed(1000, [](std::mt19937_64& rng) {
    const double angle = uniform(rng, -pi, pi);
    const double speed = uniform(rng, 0.01, 3.0);
    const double along = uniform(rng, -pi, pi);

    const EastNorth current =
        to_true_north(speed * std::cos(along), speed * std::sin(along), turned_by(angle), 0);

    EXPECT_NEAR(std::hypot(current.east, current.north), speed, 1e-6 * speed);
    const double towards = std::atan2(current.north, current.east);
    EXPECT_NEAR(std::remainder(towards - along - angle, 2.0 * pi), 0.0, 1e-6);
  });
}

// GRIB's fields were turned in single precision, the others in double; each as here.
TEST(TrueNorth, IsToTheLastDigitsWhatEverySourceComputedForItself) {
  for_each_seed(1000, [](std::mt19937_64& rng) {
    const double angle = uniform(rng, -pi, pi);
    const double u = uniform(rng, -2.0, 2.0);
    const double v = uniform(rng, -2.0, 2.0);
    const auto cosine = static_cast<float>(std::cos(angle));
    const auto sine = static_cast<float>(std::sin(angle));

    const EastNorth current = to_true_north(u, v, turned_by(angle), 0);

    EXPECT_EQ(current.east, static_cast<float>(u * cosine - v * sine));
    EXPECT_EQ(current.north, static_cast<float>(u * sine + v * cosine));
    EXPECT_NEAR(current.east, static_cast<float>(u) * cosine - static_cast<float>(v) * sine, 1e-6);
    EXPECT_NEAR(current.north, static_cast<float>(u) * sine + static_cast<float>(v) * cosine, 1e-6);
  });
}

TEST(TrueNorth, LiesFarthestFromTheSecondAxisByTheLargestTurn) {
  GridDirections directions;
  for (const double degrees : {10.0, -170.0, 30.0}) directions.add(degrees * pi / 180.0);

  EXPECT_NEAR(directions.largest_turn_deg(), 170.0, 1e-4);
}

}  // namespace
}  // namespace floeplan::ingest::true_north_test
