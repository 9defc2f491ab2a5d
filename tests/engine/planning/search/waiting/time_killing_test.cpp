#include "engine/planning/search/waiting/time_killing.hpp"

#include <gtest/gtest.h>

#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::time_killing_test {
namespace {

constexpr core::Seconds at_departure{0.0};
const geo::LocalProjection projection{{-53.0, 69.0}};
constexpr geo::PlanePoint goal{0.0, 0.0};

/// A goal that a berg 3 km long, seen drifting at a tenth of a metre a second, keeps from the beginning on.
cost::Sea sea_with_a_berg_on_the_goal(PlanRequest request) {
  static ocean::Environment environment;
  environment.icebergs = {drifting_berg(projection.to_lon_lat(goal), 3000.0, 0.1, 0.0)};
  request.icebergs.max_inflation = core::Metres{0.0};
  return cost::Sea{
      environment, request, projection, {{-10'000.0, -10'000.0}, {10'000.0, 10'000.0}}, core::Metres{500.0}};
}

core::Seconds opening_of(const cost::Sea& sea) { return sea.closed_times(goal).at(0).until; }

TEST(TimeKilling, IsTooMuchWhereTheEndOpensLongAfterTheVehicleCouldBeThere) {
  const cost::Sea sea = sea_with_a_berg_on_the_goal(support::eastward_request());
  const core::Seconds early{1.0 * hour_s};
  ASSERT_GT(opening_of(sea).count(), 3.0 * hour_s);

  const auto circling = end_opens_too_late(sea, goal, at_departure, early);

  ASSERT_TRUE(circling);
  EXPECT_NEAR(circling->count(), (opening_of(sea) - early).count(), 1e-6);
}

TEST(TimeKilling, IsBearableForLessThanAnHourOrHalfOfTheWay) {
  const cost::Sea sea = sea_with_a_berg_on_the_goal(support::eastward_request());
  const core::Seconds opens = opening_of(sea);

  EXPECT_FALSE(end_opens_too_late(sea, goal, at_departure, opens - core::Seconds{0.9 * hour_s}));
  EXPECT_FALSE(end_opens_too_late(sea, goal, at_departure, 0.51 * opens));
  EXPECT_TRUE(end_opens_too_late(sea, goal, at_departure, 0.49 * opens));
  EXPECT_FALSE(end_opens_too_late(sea, goal, at_departure, opens + core::Seconds{1.0}));
}

TEST(TimeKilling, NeedsNoCirclingWhereTheVehicleMayWait) {
  PlanRequest request = support::eastward_request();
  request.max_loiter = core::Seconds{hour_s};
  const cost::Sea sea = sea_with_a_berg_on_the_goal(request);

  EXPECT_FALSE(end_opens_too_late(sea, goal, at_departure, core::Seconds{hour_s}));
}

}  // namespace
}  // namespace floeplan::planning::search::time_killing_test
