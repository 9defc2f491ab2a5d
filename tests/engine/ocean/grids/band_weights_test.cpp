#include "engine/ocean/grids/band_weights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/ocean/currents/current_column.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ocean::band_weights_test {
namespace {

using support::uniform;
using support::uniform_int;

std::vector<double> random_levels(std::mt19937_64& rng) {
  std::vector<double> levels_m{uniform_int(rng, 0, 3) == 0 ? 0.0 : uniform(rng, 0.0, 10.0)};
  const auto count = static_cast<std::size_t>(uniform_int(rng, 1, 7));
  while (levels_m.size() < count) levels_m.push_back(levels_m.back() + uniform(rng, 1.0, 60.0));
  return levels_m;
}

TEST(BandWeights, GiveTheMeanOfTheColumn) {
  support::for_each_seed(3000, [](std::mt19937_64& rng) {
    const Axis levels_m{random_levels(rng)};
    const auto wet = static_cast<std::size_t>(uniform_int(rng, 1, static_cast<int>(levels_m.size())));
    const core::Metres top{uniform_int(rng, 0, 4) == 0 ? 0.0 : uniform(rng, 0.0, 150.0)};
    const core::Metres bottom = top + core::Metres{std::max(0.0, uniform(rng, -20.0, 200.0))};
    std::vector<geo::VelocityEn> water;
    for (std::size_t level = 0; level < wet; ++level)
      water.push_back({{uniform(rng, -1.0, 1.0)}, {uniform(rng, -1.0, 1.0)}});
    CurrentColumn column{{levels_m[0]}, water.front(), wet};
    for (std::size_t level = 1; level < wet; ++level) column.add({levels_m[level]}, water[level]);

    const std::vector<double> weights = band_weights(levels_m, wet, top, bottom);

    ASSERT_LE(weights.size(), wet);
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-12);
    geo::VelocityEn mean;
    for (std::size_t level = 0; level < weights.size(); ++level)
      mean = {mean.east + weights[level] * water[level].east,
              mean.north + weights[level] * water[level].north};
    EXPECT_NEAR(mean.east.value, column.mean(top, bottom).east.value, 1e-11);
    EXPECT_NEAR(mean.north.value, column.mean(top, bottom).north.value, 1e-11);
  });
}

TEST(BandWeights, LeaveOutWhatLiesBelowTheBand) {
  const Axis levels_m{{0.0, 10.0, 50.0, 200.0, 1000.0}};

  EXPECT_EQ(band_weights(levels_m, 5, {5.0}, {45.0}).size(), 3U);
  EXPECT_EQ(band_weights(levels_m, 5, {0.0}, {10.0}), (std::vector{0.5, 0.5}));
}

TEST(BandWeights, TakeDataWithoutDepthsForTheWholeBand) {
  EXPECT_EQ(band_weights(std::nullopt, 1, {5.0}, {200.0}), std::vector{1.0});
}

}  // namespace
}  // namespace floeplan::ocean::band_weights_test
