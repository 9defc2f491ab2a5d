#include "engine/planning/optimal_control/optimal_control.hpp"

#include <gtest/gtest.h>

#include "tests/engine/planning/paper_waters.hpp"
#include "tests/support/river_crossing.hpp"

namespace floeplan::planning::optimal_control::optimal_control_test {
namespace {

TEST(OptimalControl, CrossesTheRiverInTheTimeOfTheClosedSolution) {
  const currents::RiverCurrent river;

  const auto extremal = find_extremal(over_the_river, river, {{over_the_river.from, over_the_river.to}});

  ASSERT_TRUE(extremal.has_value());
  const double closed_s =
      support::river_crossing_by_optimal_control(river, over_the_river.through_water).count();
  EXPECT_NEAR(extremal->duration.count(), closed_s, 1e-6);
}

TEST(OptimalControl, FindsTheFastestWayThroughTheJetFromEveryCorridor) {
  const auto ways = ways_along_the_jet(3);
  ASSERT_EQ(ways.size(), 3U);

  for (const auto& way : ways) {
    const auto extremal = find_extremal(along_the_jet, currents::MeanderingJet{}, {way});

    ASSERT_TRUE(extremal.has_value());
    EXPECT_NEAR(extremal->duration.count(), 17.1588, 0.00005) << "by collocation";
  }
}

TEST(OptimalControl, SaysThatEveryStartLeavesTheData) {
  const auto extremal = find_extremal(over_the_river, currents::RiverCurrent{},
                                      {{over_the_river.from, {-5.0, 30.0}, over_the_river.to}});

  ASSERT_FALSE(extremal.has_value());
  EXPECT_EQ(extremal.error(), NoExtremal::outside_data);
}

}  // namespace
}  // namespace floeplan::planning::optimal_control::optimal_control_test
