#include "engine/ocean/grids/horizontal_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/ocean/even_axis.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ocean::horizontal_grid_test {
namespace {

const Axis latitudes = even_axis(60.0, 1.0, 11);

/// The longitude that a position stands for, counted on across the seam.
double longitude_deg(const HorizontalGrid& grid, const GridPosition& at) {
  const double lower_deg = grid.x()[at.x.lower];
  double upper_deg = grid.x()[at.x.upper];
  if (upper_deg < lower_deg) upper_deg += 360.0;
  return lower_deg + at.x.fraction * (upper_deg - lower_deg);
}

TEST(HorizontalGrid, OfTheWholeCircleAnswersAcrossItsSeam) {
  const HorizontalGrid grid{geo::GeographicFrame{}, even_axis(0.0, 0.1, 3600), latitudes};

  const auto at = grid.locate({-0.05, 65.5});

  ASSERT_TRUE(grid.wraps());
  ASSERT_TRUE(at.has_value());
  EXPECT_EQ(at->x.lower, 3599U);
  EXPECT_EQ(at->x.upper, 0U);
  EXPECT_NEAR(at->x.fraction, 0.5, 1e-9);
  EXPECT_EQ(at->y.lower, 5U);
  EXPECT_NEAR(at->y.fraction, 0.5, 1e-12);
}

TEST(HorizontalGrid, OfTheWholeCircleTakesAHairWestOfItsFirstNodeForThatNode) {
  const HorizontalGrid grid{geo::GeographicFrame{}, even_axis(0.0, 0.1, 3600), latitudes};

  for (const double hair_deg : {1e-13, 1e-8, 2e-7, 3e-7, 5e-7}) {
    const auto at = grid.locate({-hair_deg, 65.0});

    ASSERT_TRUE(at.has_value()) << hair_deg;
    EXPECT_NEAR(std::remainder(longitude_deg(grid, *at), 360.0), 0.0, 1e-6) << hair_deg;
  }
}

TEST(HorizontalGrid, OfTheWholeCircleFindsEveryLongitudeInBothConventions) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const double first_deg = support::uniform_int(rng, 0, 1) == 0 ? 0.0 : -180.0;
    const HorizontalGrid grid{geo::GeographicFrame{}, even_axis(first_deg, 0.25, 1440), latitudes};
    const double lon_deg = support::uniform(rng, -180.0, 360.0);

    const auto at = grid.locate({lon_deg, 65.5});

    ASSERT_TRUE(at.has_value());
    EXPECT_NEAR(std::remainder(longitude_deg(grid, *at) - lon_deg, 360.0), 0.0, 1e-6);
  });
}

TEST(HorizontalGrid, WithBothEndsOnOneMeridianNeedsNoSeam) {
  const HorizontalGrid grid{geo::GeographicFrame{}, even_axis(-180.0, 1.0, 361), latitudes};

  EXPECT_TRUE(grid.locate({180.0, 65.0}).has_value());
  EXPECT_TRUE(grid.locate({359.5, 65.0}).has_value());
  EXPECT_EQ(grid.bounds(), (geo::BoundingBox{-180.0, 60.0, 180.0, 70.0}));
}

TEST(HorizontalGrid, AnswersAcrossTheAntimeridian) {
  const HorizontalGrid grid{geo::GeographicFrame{}, even_axis(170.0, 1.0, 21), latitudes};

  EXPECT_FALSE(grid.wraps());
  EXPECT_EQ(grid.locate({-175.0, 65.0})->x.lower, 15U);
  EXPECT_EQ(grid.locate({185.0, 65.0})->x.lower, 15U);
  EXPECT_EQ(grid.bounds(), (geo::BoundingBox{170.0, 60.0, -170.0, 70.0}));
}

TEST(HorizontalGrid, FindsNothingBeyondItsOutermostNodes) {
  const HorizontalGrid grid{geo::GeographicFrame{}, even_axis(-60.0, 0.5, 21), latitudes};

  EXPECT_TRUE(grid.locate({-50.0, 70.0}).has_value());
  EXPECT_TRUE(grid.locate({310.0, 60.0}).has_value());
  EXPECT_FALSE(grid.locate({-49.99, 65.0}).has_value());
  EXPECT_FALSE(grid.locate({-60.01, 65.0}).has_value());
  EXPECT_FALSE(grid.locate({-55.0, 70.01}).has_value());
  EXPECT_FALSE(grid.locate({-55.0, 59.99}).has_value());
}

TEST(HorizontalGrid, RoundThePoleIsBoundedByTheWholeCircleUpToThePole) {
  const geo::PolarStereographicFrame arctic{.north = true, .lat_ts_deg = 70.0, .lon_0_deg = -45.0};
  const HorizontalGrid grid{arctic, even_axis(-1e6, 1e5, 21), even_axis(-1e6, 1e5, 21)};

  const geo::BoundingBox box = grid.bounds();

  EXPECT_EQ(geo::width_deg(box), 360.0);
  EXPECT_EQ(box.north_deg, 90.0);
  EXPECT_NEAR(box.south_deg, grid.place(0, 0).lat_deg, 1e-9);
  EXPECT_TRUE(grid.locate({123.0, 89.9}).has_value());
}

TEST(HorizontalGrid, RoundTheSouthPoleReachesDownToThePole) {
  const geo::PolarStereographicFrame antarctic{.north = false, .lat_ts_deg = -71.0, .lon_0_deg = 0.0};
  const HorizontalGrid grid{antarctic, even_axis(-1e6, 1e5, 21), even_axis(-1e6, 1e5, 21)};

  EXPECT_EQ(geo::width_deg(grid.bounds()), 360.0);
  EXPECT_EQ(grid.bounds().south_deg, -90.0);
}

TEST(HorizontalGrid, BesideThePoleIsBoundedByABoxThatHoldsItsNodes) {
  const geo::PolarStereographicFrame arctic{.north = true, .lat_ts_deg = 70.0, .lon_0_deg = -45.0};
  const HorizontalGrid grid{arctic, even_axis(-2e6, 1e5, 11), even_axis(3e5, 1e5, 11)};

  const geo::BoundingBox box = grid.bounds();

  EXPECT_LT(geo::width_deg(box), 90.0);
  for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
      EXPECT_TRUE(geo::contains(box, grid.place(ix, iy))) << ix << " " << iy;
    }
  }
}

TEST(HorizontalGrid, RoundThePoleOfAnEqualAreaPlaneReachesUpToThePole) {
  const geo::AlbersFrame arctic{.lat_1_deg = 90.0, .lat_2_deg = 90.0, .lat_0_deg = 90.0};
  const HorizontalGrid grid{arctic, even_axis(-1e6, 1e5, 21), even_axis(-1e6, 1e5, 21)};

  EXPECT_EQ(geo::width_deg(grid.bounds()), 360.0);
  EXPECT_EQ(grid.bounds().north_deg, 90.0);
}

TEST(HorizontalGrid, FindsItsOwnNodesInAProjectedFrame) {
  for (const geo::GridFrame& frame :
       {geo::GridFrame{geo::PolarStereographicFrame{.north = true, .lat_ts_deg = 70.0, .lon_0_deg = -45.0}},
        geo::GridFrame{geo::LambertConformalFrame{.lat_1_deg = 77.5, .lat_2_deg = 77.5, .lat_0_deg = 77.5}},
        geo::GridFrame{geo::AlbersFrame{.lat_1_deg = 55.0, .lat_2_deg = 65.0, .lat_0_deg = 50.0}},
        geo::GridFrame{geo::AzimuthalEqualAreaFrame{.lat_0_deg = 52.0, .lon_0_deg = 10.0}}}) {
    const HorizontalGrid grid{frame, even_axis(-2e6, 1e5, 11), even_axis(3e5, 1e5, 11)};

    const auto at = grid.locate(grid.place(4, 7));

    ASSERT_TRUE(at.has_value());
    EXPECT_EQ(at->x.lower, 4U);
    EXPECT_EQ(at->x.fraction, 0.0);
    EXPECT_EQ(at->y.lower, 7U);
    EXPECT_EQ(at->y.fraction, 0.0);
  }
}

TEST(HorizontalGrid, IsSpacedByTheSmallerOfItsTwoStepsOnTheGround) {
  const HorizontalGrid grid{geo::GeographicFrame{}, even_axis(-60.0, 1.0, 11), even_axis(55.0, 1.0, 11)};

  EXPECT_NEAR(grid.spacing().value, 55'800.0, 100.0);  // a degree of longitude at 60 N
  EXPECT_EQ((HorizontalGrid{geo::GeographicFrame{}, Axis{{0.0}}, Axis{{0.0}}}.spacing().value), 0.0);
}

}  // namespace
}  // namespace floeplan::ocean::horizontal_grid_test
