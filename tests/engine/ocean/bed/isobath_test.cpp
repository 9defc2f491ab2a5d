#include "engine/ocean/bed/isobath.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/property.hpp"

namespace floeplan::ocean::isobath_test {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

Axis axis(std::size_t nodes, double first, double step) {
  std::vector<double> values;
  for (std::size_t i = 0; i < nodes; ++i) values.push_back(first + step * static_cast<double>(i));
  return Axis{std::move(values)};
}

/// Depths by column and row on a grid of a tenth of a degree from 50 degrees west and 70 north.
template <class Depth>
Bathymetry sea_bed(std::size_t nx, std::size_t ny, const Depth& depth) {
  std::vector<float> depths_m;
  for (std::size_t y = 0; y < ny; ++y)
    for (std::size_t x = 0; x < nx; ++x) depths_m.push_back(static_cast<float>(depth(x, y)));
  return {HorizontalGrid{geo::GeographicFrame{}, axis(nx, -50.0, 0.1), axis(ny, 70.0, 0.1)},
          std::move(depths_m)};
}

TEST(Isobath, OfASlopeIsOneStraightLineWithDeepWaterOnTheLeft) {
  const auto bed = sea_bed(5, 4, [](std::size_t x, std::size_t) { return 100.0 * static_cast<double>(x); });
  const auto lines = isobaths(bed, core::Metres{150.0});
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 4U);
  EXPECT_NEAR(lines[0].front().lon_deg, -49.85, 1e-12);
  EXPECT_NEAR(lines[0].back().lon_deg, -49.85, 1e-12);
  EXPECT_GT(lines[0].front().lat_deg, lines[0].back().lat_deg);  // southwards: east is on the left
}

TEST(Isobath, RoundABankIsClosed) {
  const auto bed = sea_bed(9, 9, [](std::size_t x, std::size_t y) {
    return 40.0 * std::hypot(static_cast<double>(x) - 4.0, static_cast<double>(y) - 4.0);
  });
  const auto lines = isobaths(bed, core::Metres{100.0});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  EXPECT_GT(lines[0].size(), 8U);
}

TEST(Isobath, IsNowhereWhenTheSeaIsDeeperOrShallower) {
  const auto bed = sea_bed(4, 4, [](std::size_t, std::size_t) { return 100.0; });
  EXPECT_TRUE(isobaths(bed, core::Metres{50.0}).empty());
  EXPECT_TRUE(isobaths(bed, core::Metres{150.0}).empty());
  EXPECT_TRUE(isobaths(bed, core::Metres{100.0}).empty());
}

TEST(Isobath, EndsWhereDepthsAreMissing) {
  const auto bed = sea_bed(5, 6, [](std::size_t x, std::size_t y) {
    return x == 1 && y == 3 ? missing : 100.0 * static_cast<double>(x);
  });
  const auto lines = isobaths(bed, core::Metres{150.0});
  ASSERT_EQ(lines.size(), 2U);
  for (const auto& line : lines)
    for (const geo::LonLat place : line) EXPECT_TRUE(place.lat_deg < 70.25 || place.lat_deg > 70.35);
}

TEST(Isobath, PartsTheDeepCornersOfASaddleByTheirMean) {
  const auto saddle = [](double deep, double shallow) {
    return sea_bed(2, 2, [&](std::size_t x, std::size_t y) { return x == y ? deep : shallow; });
  };
  const auto parted = isobaths(saddle(110.0, 10.0), core::Metres{100.0});
  const auto joined = isobaths(saddle(190.0, 90.0), core::Metres{100.0});
  ASSERT_EQ(parted.size(), 2U);
  ASSERT_EQ(joined.size(), 2U);
  // Parted: each line stays near a deep corner. Joined: near a shallow one, which is lower right and upper left.
  for (const auto& line : parted)
    EXPECT_GT((line.front().lon_deg + 49.95) * (line.front().lat_deg - 70.05) +
                  (line.back().lon_deg + 49.95) * (line.back().lat_deg - 70.05),
              0.0);
  for (const auto& line : joined)
    EXPECT_LT((line.front().lon_deg + 49.95) * (line.front().lat_deg - 70.05) +
                  (line.back().lon_deg + 49.95) * (line.back().lat_deg - 70.05),
              0.0);
}

TEST(Isobath, LiesWhereTheSeaBedIsThatDeepAndPartsAllThatIsDeeper) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    const auto bed = sea_bed(12, 10, [&](std::size_t, std::size_t) {
      return support::uniform_int(rng, 0, 9) == 0 ? missing
                                                  : static_cast<float>(support::uniform(rng, 0.0, 300.0));
    });
    const double level_m = support::uniform(rng, 50.0, 250.0);
    std::size_t pieces = 0;
    for (const auto& line : isobaths(bed, core::Metres{level_m})) {
      ASSERT_GE(line.size(), 2U);
      pieces += line.size() - 1;
      for (const geo::LonLat place : line) {
        const auto depth = bed.depth(place);
        if (!depth) continue;  // rounding has put the place into the cell of a missing node
        EXPECT_NEAR(depth->value, level_m, 0.01);
      }
    }
    // The number of crossed cells, by counting the changes of side round each cell.
    std::size_t expected = 0;
    const auto& depths = bed.depth_m();
    for (std::size_t row = 0; row + 1 < 10; ++row) {
      for (std::size_t column = 0; column + 1 < 12; ++column) {
        const std::size_t node = row * 12 + column;
        const float round[]{depths[node], depths[node + 1], depths[node + 13], depths[node + 12],
                            depths[node]};
        std::size_t changes = 0;
        for (int i = 0; i < 4; ++i) changes += (round[i] >= level_m) != (round[i + 1] >= level_m) ? 1 : 0;
        if (!std::isnan(round[0] + round[1] + round[2] + round[3])) expected += changes / 2;
      }
    }
    EXPECT_EQ(pieces, expected);
  });
}

}  // namespace
}  // namespace floeplan::ocean::isobath_test
