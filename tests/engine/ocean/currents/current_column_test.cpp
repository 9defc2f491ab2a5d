#include "engine/ocean/currents/current_column.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace floeplan::ocean::current_column_test {
namespace {

CurrentColumn eastward(const std::vector<double>& depths_m, const std::vector<double>& east_m_s) {
  const auto velocity = [&](std::size_t i) { return geo::VelocityEn{{east_m_s[i]}, {-2.0 * east_m_s[i]}}; };
  CurrentColumn column{{depths_m.front()}, velocity(0), depths_m.size()};
  for (std::size_t i = 1; i < depths_m.size(); ++i) column.add({depths_m[i]}, velocity(i));
  return column;
}

TEST(CurrentColumn, AveragesABandThatEndsInsideItsLayers) {
  const CurrentColumn column = eastward({0.0, 10.0, 50.0}, {0.4, 0.2, 0.0});

  // 5-10 m: from 0.3 to 0.2 m/s; 10-30 m: from 0.2 to 0.1.
  EXPECT_NEAR(column.mean({5.0}, {30.0}).east.value, (5.0 * 0.25 + 20.0 * 0.15) / 25.0, 1e-12);
  EXPECT_NEAR(column.mean({5.0}, {30.0}).north.value, -2.0 * (5.0 * 0.25 + 20.0 * 0.15) / 25.0, 1e-12);
}

TEST(CurrentColumn, InterpolatesABandThinnerThanALayer) {
  EXPECT_NEAR(eastward({0.0, 100.0}, {1.0, 0.0}).mean({40.0}, {42.0}).east.value, 0.59, 1e-12);
}

TEST(CurrentColumn, IsAsAtItsFirstLevelAboveIt) {
  EXPECT_NEAR(eastward({10.0, 20.0}, {0.4, 0.2}).mean({2.0}, {10.0}).east.value, 0.4, 1e-12);
}

TEST(CurrentColumn, LeavesOutWhatIsBelowItsLowestWater) {
  const CurrentColumn column = eastward({0.0, 10.0}, {0.4, 0.2});

  EXPECT_NEAR(column.mean({0.0}, {1000.0}).east.value, 0.3, 1e-12);
  EXPECT_NEAR(column.mean({500.0}, {1000.0}).east.value, 0.2, 1e-12);
}

TEST(CurrentColumn, GivesTheCurrentAtADepthForABandWithoutThickness) {
  EXPECT_NEAR(eastward({0.0, 10.0}, {0.4, 0.2}).mean({5.0}, {5.0}).east.value, 0.3, 1e-12);
}

TEST(CurrentColumn, AgreesWithASumOverManyThinLayers) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    std::vector<double> depths_m{support::uniform(rng, 0.0, 5.0)};
    std::vector<double> east{support::uniform(rng, -1.0, 1.0)};
    for (int i = 0; i < 6; ++i) {
      depths_m.push_back(depths_m.back() + support::uniform(rng, 1.0, 60.0));
      east.push_back(support::uniform(rng, -1.0, 1.0));
    }
    const CurrentColumn column = eastward(depths_m, east);
    const double top_m = support::uniform(rng, 0.0, depths_m.back());
    const double bottom_m = support::uniform(rng, top_m, depths_m.back());

    double sum = 0.0;
    constexpr int layers = 20'000;
    for (int i = 0; i < layers; ++i) {
      const core::Metres depth{top_m + (bottom_m - top_m) * (i + 0.5) / layers};
      sum += column.mean(depth, depth).east.value;
    }

    EXPECT_NEAR(column.mean({top_m}, {bottom_m}).east.value, sum / layers, 1e-6);
  });
}

}  // namespace
}  // namespace floeplan::ocean::current_column_test
