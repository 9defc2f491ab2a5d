#include "engine/planning/iceberg_discs.hpp"

#include <gtest/gtest.h>

#include "engine/geo/geodesic.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};

TEST(IcebergDiscs, KeepHalfTheLengthTheUncertaintyAndTheMargin) {
  ocean::Iceberg berg = support::iceberg_at({-53.0, 69.0}, 200.0);
  berg.position_uncertainty = core::Metres{300.0};
  const IcebergDiscs discs{{berg}, core::Metres{500.0}, projection};
  const auto eastwards = [&](double distance_m) {
    return projection.to_plane(
        geo::geodesic_destination({-53.0, 69.0}, geo::Bearing::degrees(90.0), core::Metres{distance_m}));
  };

  EXPECT_TRUE(discs.contains(eastwards(899.0)));
  EXPECT_FALSE(discs.contains(eastwards(901.0)));
  EXPECT_NEAR(discs.distance_from_hulls(eastwards(901.0), eastwards(2000.0))->value, 801.0, 0.1);
}

TEST(IcebergDiscs, AgreeWithTheirBruteForce) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    std::uniform_real_distribution<double> lon{-54.0, -52.0};
    std::uniform_real_distribution<double> lat{68.6, 69.4};
    std::uniform_real_distribution<double> length{20.0, 3000.0};
    std::vector<ocean::Iceberg> bergs;
    for (int i = 0; i < 40; ++i) bergs.push_back(support::iceberg_at({lon(rng), lat(rng)}, length(rng)));
    const IcebergDiscs all{bergs, core::Metres{500.0}, projection};

    for (int i = 0; i < 50; ++i) {
      const geo::PlanePoint a = projection.to_plane(geo::LonLat{lon(rng), lat(rng)});
      const geo::PlanePoint b = projection.to_plane(geo::LonLat{lon(rng), lat(rng)});
      bool touched = false;
      for (const ocean::Iceberg& berg : bergs) {
        touched = touched || IcebergDiscs{{berg}, core::Metres{500.0}, projection}.crosses(a, b);
      }
      EXPECT_EQ(all.crosses(a, b), touched);
      EXPECT_EQ(all.crosses(b, a), touched);
    }
  });
}

}  // namespace
}  // namespace floeplan::planning
