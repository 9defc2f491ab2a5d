#include "engine/planning/obstacles/least_depth_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/property.hpp"

namespace floeplan::planning::obstacles::least_depth_rows_test {
namespace {

using support::for_each_seed;
using support::uniform;

constexpr geo::LonLat middle{-52.0, 69.0};

ocean::HorizontalGrid grid_about(geo::LonLat place, double step_lon, double step_lat, int nodes) {
  std::vector<double> lon;
  std::vector<double> lat;
  for (int i = 0; i < nodes; ++i) {
    lon.push_back(place.lon_deg + (i - nodes / 2) * step_lon);
    lat.push_back(place.lat_deg + (i - nodes / 2) * step_lat);
  }
  return {geo::GeographicFrame{}, ocean::Axis{lon}, ocean::Axis{lat}};
}

std::vector<float> least_depths(const plane::PlaneRaster& raster, const ocean::Bathymetry& bathymetry,
                                core::Metres enough, const geo::LocalProjection& projection) {
  LeastDepthRows rows{raster, bathymetry, enough, projection, {}};
  std::vector<float> all;
  for (std::int64_t row = 0; row < raster.ny(); ++row)
    std::ranges::copy(rows.next(), std::back_inserter(all));
  return all;
}

TEST(LeastDepthRows, AreBelowEveryDepthInTheirCellsAndNotMuch) {
  std::size_t known = 0;
  for_each_seed(40, [&](std::mt19937_64& rng) {
    const geo::LonLat place{uniform(rng, -180.0, 180.0), uniform(rng, -80.0, 80.0)};
    const geo::LocalProjection projection{place};
    const auto grid = grid_about(place, uniform(rng, 0.002, 0.05), uniform(rng, 0.002, 0.02), 40);
    std::vector<float> depths(grid.size());
    for (float& depth : depths) depth = static_cast<float>(uniform(rng, 1.0, 100.0));
    const ocean::Bathymetry bathymetry{grid, depths};
    const plane::PlaneRaster raster{{{-1000.0, -1000.0}, {1000.0, 1000.0}},
                                    core::Metres{uniform(rng, 50.0, 400.0)}};

    const auto exact = least_depths(raster, bathymetry, core::Metres{1000.0}, projection);
    const auto enough = least_depths(raster, bathymetry, core::Metres{20.0}, projection);

    for (int i = 0; i < 3000; ++i) {
      const geo::PlanePoint point{uniform(rng, -1000.0, 1000.0), uniform(rng, -1000.0, 1000.0)};
      const auto depth = bathymetry.depth(projection.to_lon_lat(point));
      if (!depth) continue;
      const auto cell = raster.index(point);
      const float least = exact[cell.value()];
      EXPECT_FALSE(least > depth->value + 0.2);  // the table of the plane is true to a metre
      EXPECT_EQ(exact[*cell] < 20.0F, enough[*cell] < 20.0F);
      known += least > 0.0F ? 1 : 0;
    }
  });
  EXPECT_GT(known, 50'000U);

  const auto grid = grid_about(middle, 0.02, 0.01, 21);
  const ocean::Bathymetry flat{grid, std::vector<float>(grid.size(), 50.0F)};
  const plane::PlaneRaster raster{{{-1000.0, -1000.0}, {1000.0, 1000.0}}, core::Metres{100.0}};
  for (const float least : least_depths(raster, flat, core::Metres{1000.0}, geo::LocalProjection{middle}))
    EXPECT_NEAR(least, 50.0F, 1e-3F);
}

TEST(LeastDepthRows, SeeARidgeOfOneRowBetweenTheCornersOfTheirCells) {
  const geo::LocalProjection projection{middle};
  const auto grid = grid_about(middle, 0.011, 0.004, 21);
  std::vector<float> depths(grid.size(), 200.0F);
  std::fill_n(depths.begin() + 10 * 21, 21, -2.0F);
  const ocean::Bathymetry bathymetry{grid, depths};
  const plane::PlaneRaster raster{{{-1050.0, -1050.0}, {1050.0, 1050.0}}, core::Metres{100.0}};

  const auto least = least_depths(raster, bathymetry, core::Metres{20.0}, projection);

  for (std::int64_t ix = 0; ix < raster.nx(); ++ix)
    EXPECT_LE(least[raster.index(ix, 10)], 0.0F) << "column " << ix;
  EXPECT_GE(least[raster.index(5, 15)], 20.0F);
}

TEST(LeastDepthRows, AreTheSameAcrossTheSeamOfTheLongitudes) {
  const geo::LonLat seam{180.0, 60.0};
  const geo::LocalProjection projection{seam};
  std::vector<double> lon;
  for (int i = 0; i < 720; ++i) lon.push_back(-180.0 + 0.5 * i);
  const ocean::HorizontalGrid round{geo::GeographicFrame{}, ocean::Axis{lon},
                                    ocean::Axis{{59.0, 60.1, 61.0}}};
  std::vector<float> depths(round.size(), 300.0F);
  depths[720] = 5.0F;  // on the seam, at 60.1 N
  const ocean::Bathymetry bathymetry{round, depths};
  const plane::PlaneRaster raster{{{-20'000.0, -20'000.0}, {20'000.0, 20'000.0}}, core::Metres{8000.0}};

  const auto least = least_depths(raster, bathymetry, core::Metres{1000.0}, projection);

  EXPECT_NEAR(least[raster.index(projection.to_plane({180.0, 60.1})).value()], 5.0, 1e-3);
}

TEST(LeastDepthRows, AreNotKnownWhereANodeIsMissingUnlessLandIsThere) {
  const geo::LocalProjection projection{middle};
  const auto grid = grid_about(middle, 0.011, 0.004, 21);
  std::vector<float> depths(grid.size(), 200.0F);
  depths[10 * 21 + 10] = NAN;
  const plane::PlaneRaster raster{{{-1050.0, -1050.0}, {1050.0, 1050.0}}, core::Metres{100.0}};

  const auto with_hole = least_depths(raster, {grid, depths}, core::Metres{20.0}, projection);
  EXPECT_TRUE(std::isnan(with_hole[raster.index(10, 10)]));
  EXPECT_GE(with_hole[raster.index(1, 1)], 20.0F);

  std::ranges::replace(depths, 200.0F, -3.0F);
  const auto land = least_depths(raster, {grid, depths}, core::Metres{20.0}, projection);
  EXPECT_LE(land[raster.index(1, 1)], 0.0F);
}

}  // namespace
}  // namespace floeplan::planning::obstacles::least_depth_rows_test
