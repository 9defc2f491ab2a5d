#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/engine/ocean/sample_currents.hpp"

namespace floeplan::ocean::depth_average_test {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
constexpr geo::LonLat place{-53.5, 68.5};

/// The same column of eastward currents everywhere.
CurrentGrid same_column(const Axis& depths_m, std::vector<float> east) {
  return sample_currents(depths_m, 1, [=](SampleIndex i) { return east[i.level]; });
}

double average_m_s(const CurrentGrid& currents, double dive_depth_m) {
  return currents.depth_average(place, {dive_depth_m}, 0)->east.value;
}

TEST(DepthAverage, AddsUpTrapezoidsDownToTheDiveDepth) {
  const CurrentGrid currents = same_column(Axis{{0.0, 10.0, 50.0, 100.0}}, {0.4F, 0.2F, 0.1F, 0.0F});

  // 0-10 m: 3.0; 10-50 m: 6.0; 50-100 m: 2.5 (m/s times m).
  EXPECT_NEAR(average_m_s(currents, 10.0), 3.0 / 10.0, 1e-7);
  EXPECT_NEAR(average_m_s(currents, 50.0), 9.0 / 50.0, 1e-7);
  EXPECT_NEAR(average_m_s(currents, 100.0), 11.5 / 100.0, 1e-7);
}

TEST(DepthAverage, EndsInsideALayer) {
  const CurrentGrid currents = same_column(Axis{{0.0, 10.0, 50.0, 100.0}}, {0.4F, 0.2F, 0.1F, 0.0F});

  // 10-30 m: from 0.2 down to 0.15 m/s.
  EXPECT_NEAR(average_m_s(currents, 30.0), (3.0 + 3.5) / 30.0, 1e-7);
  EXPECT_NEAR(average_m_s(currents, 5.0), 0.35, 1e-7);
}

TEST(DepthAverage, GoesNoDeeperThanTheLowestLevel) {
  const CurrentGrid currents = same_column(Axis{{0.0, 10.0, 50.0}}, {0.4F, 0.2F, 0.1F});

  EXPECT_NEAR(average_m_s(currents, 1000.0), 9.0 / 50.0, 1e-7);
}

TEST(DepthAverage, LeavesOutTheLevelsBelowTheSeaBed) {
  const CurrentGrid currents = same_column(Axis{{0.0, 10.0, 50.0, 100.0}}, {0.4F, 0.2F, missing, missing});

  EXPECT_NEAR(average_m_s(currents, 100.0), 0.3, 1e-7);
}

TEST(DepthAverage, TakesTheFirstLevelForTheWaterAboveIt) {
  const CurrentGrid currents = same_column(Axis{{5.0, 15.0}}, {0.4F, 0.2F});

  // 0-5 m: 2.0; 5-15 m: 3.0.
  EXPECT_NEAR(average_m_s(currents, 15.0), 5.0 / 15.0, 1e-7);
  EXPECT_NEAR(average_m_s(currents, 3.0), 0.4, 1e-7);
}

TEST(DepthAverage, OfASingleLevelOrNoneIsThatLevel) {
  const CurrentGrid no_levels = sample_currents(std::nullopt, 1, [](SampleIndex) { return 0.25F; });

  EXPECT_NEAR(average_m_s(same_column(Axis{{0.0}}, {0.25F}), 200.0), 0.25, 1e-7);
  EXPECT_NEAR(average_m_s(same_column(Axis{{12.0}}, {0.25F}), 200.0), 0.25, 1e-7);
  EXPECT_NEAR(average_m_s(no_levels, 200.0), 0.25, 1e-7);
}

TEST(DepthAverage, IsUnknownOverLandAndBeyondTheGrid) {
  const CurrentGrid land = same_column(Axis{{0.0, 10.0}}, {missing, missing});
  const CurrentGrid sea = same_column(Axis{{0.0, 10.0}}, {0.1F, 0.1F});

  EXPECT_FALSE(land.depth_average(place, {10.0}, 0).has_value());
  EXPECT_FALSE(land.column_at_node(0, 0, 0).has_value());
  EXPECT_FALSE(sea.depth_average(geo::LonLat{0.0, 0.0}, {10.0}, 0).has_value());
}

TEST(DepthAverage, AtANodeIsThatOfTheNodesPlace) {
  const CurrentGrid currents = sample_currents(Axis{{0.0, 10.0, 50.0}}, 2, [](SampleIndex i) {
    return 0.1F * static_cast<float>(i.ix) - 0.05F * static_cast<float>(i.iy * i.level) +
           0.2F * static_cast<float>(i.time);
  });

  const auto at_node = currents.column_at_node(2, 1, 1);

  ASSERT_TRUE(at_node.has_value());
  EXPECT_EQ(at_node->mean({0.0}, {40.0}),
            currents.depth_average(currents.samples().grid.place(2, 1), {40.0}, 1));
}

}  // namespace
}  // namespace floeplan::ocean::depth_average_test
