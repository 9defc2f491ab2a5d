#include "storage/repository/fields/bathymetry_mosaic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/property.hpp"

namespace floeplan::repository::bathymetry_mosaic_test {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
constexpr geo::BoundingBox area{-54.0, 68.0, -52.0, 69.0};

/// A geographic grid from the south-west corner on.
ocean::HorizontalGrid grid(double west_deg, double south_deg, double step_deg, std::size_t nx,
                           std::size_t ny) {
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < nx; ++i) x.push_back(west_deg + step_deg * static_cast<double>(i));
  for (std::size_t i = 0; i < ny; ++i) y.push_back(south_deg + step_deg * static_cast<double>(i));
  return {geo::GeographicFrame{}, ocean::Axis{x}, ocean::Axis{y}};
}

ocean::Bathymetry flat(const ocean::HorizontalGrid& nodes, float depth_m) {
  return {nodes, std::vector<float>(nodes.size(), depth_m)};
}

TEST(BathymetryMosaic, TakesTheFirstDatasetThatKnowsThePlace) {
  BathymetryMosaic mosaic{area, core::Metres{2000.0}, 1'000'000};
  EXPECT_TRUE(mosaic.add(flat(grid(-53.0, 68.2, 0.02, 30, 30), 50.0F)));
  EXPECT_FALSE(mosaic.is_complete());
  EXPECT_TRUE(mosaic.add(flat(grid(-55.0, 67.0, 0.5, 10, 10), 400.0F)));
  EXPECT_TRUE(mosaic.is_complete());
  EXPECT_FALSE(mosaic.add(flat(grid(-55.0, 67.0, 0.5, 10, 10), 900.0F)));

  const ocean::Bathymetry depths = mosaic.bathymetry();
  EXPECT_EQ(depths.depth({-52.7, 68.5})->value, 50.0);
  EXPECT_EQ(depths.depth({-53.7, 68.8})->value, 400.0);
}

TEST(BathymetryMosaic, JoinsTilesInDifferentProjections) {
  const auto tile = [](const geo::GridFrame& frame, geo::LonLat middle) {
    const geo::GridPoint at = geo::FrameProjection{frame}.to_grid(middle);
    std::vector<double> x;
    std::vector<double> y;
    for (int i = -10; i <= 10; ++i) {
      x.push_back(at.x + 500.0 * i);
      y.push_back(at.y + 500.0 * i);
    }
    return ocean::HorizontalGrid{frame, ocean::Axis{x}, ocean::Axis{y}};
  };
  const geo::TransverseMercatorFrame utm_22{.lon_0_deg = -51.0, .false_easting_m = 500'000.0};
  const geo::AzimuthalEqualAreaFrame azimuthal{.lat_0_deg = 52.0, .lon_0_deg = 10.0};
  const geo::LambertConformalFrame conic{
      .lat_1_deg = 60.0, .lat_2_deg = 75.0, .lat_0_deg = 69.0, .lon_0_deg = -40.0};
  BathymetryMosaic mosaic{area, core::Metres{500.0}, 1'000'000};
  EXPECT_TRUE(mosaic.add(flat(tile(utm_22, {-52.5, 68.3}), 100.0F)));
  EXPECT_TRUE(mosaic.add(flat(tile(azimuthal, {-53.0, 68.5}), 200.0F)));
  EXPECT_TRUE(mosaic.add(flat(tile(conic, {-53.5, 68.7}), 300.0F)));

  const ocean::Bathymetry depths = mosaic.bathymetry();
  EXPECT_EQ(depths.depth({-52.5, 68.3})->value, 100.0);
  EXPECT_EQ(depths.depth({-53.0, 68.5})->value, 200.0);
  EXPECT_EQ(depths.depth({-53.5, 68.7})->value, 300.0);
  EXPECT_FALSE(depths.depth({-52.2, 68.8}).has_value());
}

/// Depths that grow with the latitude, so that a node in the cell of another one would show.
TEST(BathymetryMosaic, TakesTheNodesOfAProjectedTileWhereTheyLie) {
  struct Tile {
    geo::GridFrame frame;
    geo::LonLat middle;
    geo::BoundingBox area;
  };
  for (const auto& [frame, middle, around] :
       {Tile{geo::AzimuthalEqualAreaFrame{.lat_0_deg = 52.0, .lon_0_deg = 10.0}, {-53.0, 68.5}, area},
        Tile{geo::PolarStereographicFrame{}, {0.0, 90.0}, {-180.0, 89.6, 180.0, 90.0}},
        Tile{geo::LambertConformalFrame{.lon_0_deg = 180.0}, {180.0, 60.0}, {179.5, 59.5, -179.5, 60.5}}}) {
    const geo::GridPoint at = geo::FrameProjection{frame}.to_grid(middle);
    std::vector<double> x;
    std::vector<double> y;
    for (int i = -250; i <= 250; ++i) {
      x.push_back(at.x + 100.0 * i);
      y.push_back(at.y + 100.0 * i);
    }
    const ocean::HorizontalGrid nodes{frame, ocean::Axis{x}, ocean::Axis{y}};
    const auto depth_at = [](double lat_deg) { return 5000.0 + 1000.0 * (lat_deg - 80.0) / 10.0; };
    std::vector<float> depths_m;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      depths_m.push_back(static_cast<float>(depth_at(nodes.place(i % x.size(), i / x.size()).lat_deg)));
    BathymetryMosaic mosaic{around, core::Metres{1000.0}, 1'000'000};
    mosaic.add({nodes, depths_m});

    const ocean::Bathymetry result = mosaic.bathymetry();
    std::size_t known = 0;
    for (std::size_t i = 0; i < result.grid().size(); ++i) {
      if (std::isnan(result.depth_m()[i])) continue;
      ++known;
      const auto place = result.grid().place(i % result.grid().x().size(), i / result.grid().x().size());
      ASSERT_NEAR(static_cast<double>(result.depth_m()[i]), depth_at(place.lat_deg), 0.6)
          << "half a cell, 0.9 m";
    }
    EXPECT_GT(known, 500U);
  }
}

TEST(BathymetryMosaic, FollowsAPlaneSeaBedExactlyAtItsNodes) {
  const ocean::HorizontalGrid nodes = grid(-55.0, 67.0, 0.25, 20, 20);
  std::vector<float> depths_m;
  for (std::size_t iy = 0; iy < 20; ++iy)
    for (std::size_t ix = 0; ix < 20; ++ix)
      depths_m.push_back(
          static_cast<float>(100.0 + 8.0 * static_cast<double>(ix) + 4.0 * static_cast<double>(iy)));
  BathymetryMosaic mosaic{area, core::Metres{9000.0}, 1'000'000};
  mosaic.add({nodes, depths_m});

  const ocean::Bathymetry result = mosaic.bathymetry();
  for (std::size_t i = 0; i < result.grid().size(); ++i) {
    const geo::LonLat place = result.grid().place(i % result.grid().x().size(), i / result.grid().x().size());
    const double expected = 100.0 + 8.0 * (place.lon_deg + 55.0) / 0.25 + 4.0 * (place.lat_deg - 67.0) / 0.25;
    ASSERT_NEAR(static_cast<double>(result.depth_m()[i]), expected, 8.0) << "a mean of the nodes in its cell";
    ASSERT_LE(result.shoalest_m()[i], result.depth_m()[i]);
  }
}

TEST(BathymetryMosaic, KeepsTheLeastDepthOfACellBesideItsMean) {
  const ocean::HorizontalGrid nodes = grid(-54.5, 67.5, 0.01, 300, 200);
  std::vector<float> depths_m(nodes.size(), 80.0F);
  depths_m[100 * 300 + 150] = 3.0F;  // a rock at 53 W, 68.5 N
  BathymetryMosaic mosaic{area, core::Metres{10'000.0}, 1'000'000};
  mosaic.add({nodes, depths_m});

  EXPECT_EQ(mosaic.bathymetry().shoalest({-53.0, 68.5})->value, 3.0);
  EXPECT_GT(mosaic.bathymetry().depth({-53.0, 68.5})->value, 70.0);
}

TEST(BathymetryMosaic, RemembersAShoalAtTheEdgeOfADataset) {
  ocean::HorizontalGrid nodes = grid(-53.003, 68.497, 0.002, 3, 3);
  BathymetryMosaic mosaic{area, core::Metres{10'000.0}, 1'000'000};
  mosaic.add({nodes, {missing, missing, missing, missing, 2.0F, missing, missing, missing, missing}});
  mosaic.add(flat(grid(-55.0, 67.0, 0.5, 10, 10), 400.0F));

  EXPECT_EQ(mosaic.bathymetry().shoalest({-53.001, 68.499})->value, 2.0);
}

TEST(BathymetryMosaic, BecomesCoarserRatherThanLargerThanAllowed) {
  const BathymetryMosaic mosaic{area, core::Metres{1.0}, 10'000};

  EXPECT_LT(mosaic.bathymetry().grid().size(), 11'000U);
}

TEST(BathymetryMosaic, RunsAcrossTheAntimeridian) {
  BathymetryMosaic mosaic{{179.0, -1.0, -179.0, 1.0}, core::Metres{20'000.0}, 1'000'000};
  mosaic.add(flat(grid(170.0, -5.0, 1.0, 21, 11), 70.0F));

  EXPECT_TRUE(mosaic.is_complete());
  EXPECT_EQ(mosaic.bathymetry().depth({-179.5, 0.3})->value, 70.0);
  EXPECT_EQ(mosaic.bathymetry().depth({179.5, 0.3})->value, 70.0);
}

TEST(BathymetryMosaic, IsNowhereDeeperThanTheNodesOfItsData) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    std::uniform_real_distribution<float> depth{1.0F, 300.0F};
    std::uniform_real_distribution<double> step{0.01, 0.1};
    const double apart = step(rng);
    const ocean::HorizontalGrid nodes = grid(-54.5, 67.5, apart, static_cast<std::size_t>(3.0 / apart),
                                             static_cast<std::size_t>(2.0 / apart));
    std::vector<float> depths_m(nodes.size());
    for (float& each : depths_m) each = depth(rng);
    BathymetryMosaic mosaic{area, core::Metres{5000.0}, 1'000'000};
    mosaic.add({nodes, depths_m});
    const ocean::Bathymetry result = mosaic.bathymetry();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const geo::LonLat place = nodes.place(i % nodes.x().size(), i / nodes.x().size());
      if (!geo::contains(area, place)) continue;
      ASSERT_LE(result.shoalest(place)->value, static_cast<double>(depths_m[i]) + 1e-4);
    }
  });
}

}  // namespace
}  // namespace floeplan::repository::bathymetry_mosaic_test
