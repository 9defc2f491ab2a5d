#include "engine/ocean/band_mean.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/support/property.hpp"

namespace floeplan::ocean {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

/// Two by two nodes at two times, each with water down to a level of its own, or with none.
CurrentGrid random_currents(std::mt19937_64& rng) {
  const auto levels = static_cast<std::size_t>(support::uniform_int(rng, 1, 7));
  std::vector<double> depths_m{support::uniform(rng, 0.0, 10.0)};
  if (support::uniform_int(rng, 0, 3) == 0) depths_m.front() = 0.0;
  while (depths_m.size() < levels) depths_m.push_back(depths_m.back() + support::uniform(rng, 1.0, 60.0));
  CurrentGrid::Samples samples{.grid = {geo::GeographicFrame{}, Axis{{0.0, 1.0}}, Axis{{0.0, 1.0}}},
                               .depths_m = Axis{depths_m},
                               .times_s = Axis{{0.0, 3600.0}},
                               .u = std::vector<float>(8 * levels, missing),
                               .v = std::vector<float>(8 * levels, missing)};
  if (levels == 1 && support::uniform_int(rng, 0, 1) == 0) samples.depths_m.reset();
  for (std::size_t time = 0; time < 2; ++time) {
    for (std::size_t node = 0; node < 4; ++node) {
      const auto wet = static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(levels)));
      for (std::size_t level = 0; level < wet; ++level) {
        samples.u[(time * levels + level) * 4 + node] = static_cast<float>(support::uniform(rng, -1.0, 1.0));
        samples.v[(time * levels + level) * 4 + node] = static_cast<float>(support::uniform(rng, -1.0, 1.0));
      }
    }
  }
  return CurrentGrid{std::move(samples)};
}

TEST(BandMean, IsThatOfTheColumn) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const CurrentGrid currents = random_currents(rng);
    const core::Metres top{support::uniform(rng, 0.0, 150.0)};
    const core::Metres bottom = top + core::Metres{std::max(0.0, support::uniform(rng, -20.0, 200.0))};
    for (const std::size_t time : {0U, 1U}) {
      for (const std::size_t iy : {0U, 1U}) {
        for (const std::size_t ix : {0U, 1U}) {
          const auto column = currents.column_at_node(ix, iy, time);
          const auto mean = band_mean_at_node(currents, ix, iy, time, top, bottom);
          ASSERT_EQ(mean.has_value(), column.has_value());
          if (!column) continue;
          const geo::VelocityEn of_column = column->mean(top, bottom);
          EXPECT_NEAR(mean->east.value, of_column.east.value, 1e-12);
          EXPECT_NEAR(mean->north.value, of_column.north.value, 1e-12);
        }
      }
    }
  });
}

}  // namespace
}  // namespace floeplan::ocean
