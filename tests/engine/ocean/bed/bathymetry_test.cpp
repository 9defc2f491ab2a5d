#include "engine/ocean/bed/bathymetry.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/engine/ocean/even_axis.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ocean::bathymetry_test {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

/// Three columns 54 W to 52 W, two rows 68 N and 69 N.
Bathymetry small_chart(std::vector<float> depth_m) {
  return {HorizontalGrid{geo::GeographicFrame{}, even_axis(-54.0, 1.0, 3), even_axis(68.0, 1.0, 2)},
          std::move(depth_m)};
}

TEST(Bathymetry, IsExactOnItsNodesAndTheMeanInTheMiddleOfACell) {
  const Bathymetry chart = small_chart({100.0F, 200.0F, 300.0F,  //
                                        500.0F, 0.0F, -20.0F});

  EXPECT_EQ(chart.depth({-54.0, 68.0})->value, 100.0);
  EXPECT_EQ(chart.depth({-52.0, 69.0})->value, -20.0);
  EXPECT_NEAR(chart.depth({-53.5, 68.5})->value, 200.0, 1e-9);
  EXPECT_NEAR(chart.depth({-52.5, 69.0})->value, -10.0, 1e-9);
}

TEST(Bathymetry, IsUnknownBeyondItsGrid) {
  const Bathymetry chart = small_chart(std::vector<float>(6, 100.0F));

  EXPECT_FALSE(chart.depth({-51.9, 68.5}).has_value());
  EXPECT_FALSE(chart.depth({-53.0, 69.1}).has_value());
}

TEST(Bathymetry, IsUnknownWhereANodeItNeedsIsMissingAndKnownBesideIt) {
  const Bathymetry chart = small_chart({100.0F, 200.0F, missing,  //
                                        100.0F, 200.0F, 300.0F});

  EXPECT_FALSE(chart.depth({-52.5, 68.5}).has_value());
  EXPECT_FALSE(chart.depth({-52.0, 68.0}).has_value());
  EXPECT_TRUE(chart.depth({-53.0, 68.5}).has_value());
  EXPECT_TRUE(chart.depth({-52.5, 69.0}).has_value());
}

TEST(Bathymetry, FollowsAPlaneSeaBedExactly) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const int east_m = support::uniform_int(rng, -100, 100);
    const int north_m = support::uniform_int(rng, -100, 100);
    std::vector<float> depth_m;
    for (int iy = 0; iy < 2; ++iy) {
      for (int ix = 0; ix < 3; ++ix) depth_m.push_back(static_cast<float>(500 + east_m * ix + north_m * iy));
    }
    const double dx = support::uniform(rng, 0.0, 2.0);
    const double dy = support::uniform(rng, 0.0, 1.0);

    const auto depth = small_chart(depth_m).depth({-54.0 + dx, 68.0 + dy});

    ASSERT_TRUE(depth.has_value());
    EXPECT_NEAR(depth->value, 500.0 + east_m * dx + north_m * dy, 1e-3);
  });
}

TEST(Bathymetry, NeedsADepthForEachNode) {
  EXPECT_THROW(
      (Bathymetry{HorizontalGrid{geo::GeographicFrame{}, even_axis(0.0, 1.0, 2), even_axis(0.0, 1.0, 2)},
                  std::vector<float>(4, 1.0F), std::vector<float>(3, 1.0F)}),
      std::invalid_argument);
  EXPECT_THROW((void)small_chart({1.0F, 2.0F}), std::invalid_argument);
}

TEST(Bathymetry, IsNoShoalerThanItsNodesWhereNothingElseIsKnown) {
  const Bathymetry chart = small_chart({100.0F, 200.0F, 300.0F, 500.0F, 0.0F, -20.0F});

  EXPECT_EQ(chart.shoalest({-53.5, 68.5}), chart.depth({-53.5, 68.5}));
  EXPECT_EQ(chart.shoalest_m(), chart.depth_m());
}

TEST(Bathymetry, KnowsTheLeastDepthOfTheCellsAroundAPlace) {
  const Bathymetry chart{
      HorizontalGrid{geo::GeographicFrame{}, even_axis(-54.0, 1.0, 3), even_axis(68.0, 1.0, 2)},
      std::vector<float>(6, 100.0F),
      {100.0F, 7.0F, 100.0F, 100.0F, 100.0F, missing}};

  EXPECT_EQ(chart.depth({-53.4, 68.1})->value, 100.0);
  EXPECT_EQ(chart.shoalest({-53.4, 68.1})->value, 7.0) << "the shoal may lie anywhere in its cell";
  EXPECT_EQ(chart.shoalest({-52.1, 68.9})->value, 7.0);
  EXPECT_EQ(chart.shoalest({-54.0, 69.0})->value, 100.0);
}

TEST(Bathymetry, IsAsDeepAtAPointOfItsFrameAsAtThePlaceThere) {
  const geo::GridFrame utm_22 =
      geo::TransverseMercatorFrame{.lon_0_deg = -51.0, .false_easting_m = 500'000.0};
  const Bathymetry chart{HorizontalGrid{utm_22, even_axis(500'000.0, 100.0, 3), even_axis(7.6e6, 100.0, 2)},
                         {100.0F, 200.0F, 300.0F, 500.0F, 0.0F, -20.0F}};
  support::for_each_seed(50, [&](std::mt19937_64& rng) {
    const geo::GridPoint point{support::uniform(rng, 499'900.0, 500'300.0),
                               support::uniform(rng, 7'599'900.0, 7'600'200.0)};
    const auto at_point = chart.shoalest_at(point);
    const auto at_place = chart.shoalest(geo::FrameProjection{utm_22}.to_lon_lat(point));
    ASSERT_EQ(at_point.has_value(), at_place.has_value());
    if (at_point) {
      EXPECT_NEAR(at_point->value, at_place->value, 1e-4);
    }
  });
}

}  // namespace
}  // namespace floeplan::ocean::bathymetry_test
