#include "engine/planning/publish/held_legs.hpp"

#include <gtest/gtest.h>

#include "engine/planning/cost/route_cost.hpp"
#include "tests/engine/planning/publish/berg_across.hpp"

namespace floeplan::planning::publish::held_legs_test {
namespace {

class LegsWithAHold : public BergAcross {
 protected:
  cost::Route route_{{{0.0, 0.0}, {5000.0, 0.0}, {8000.0, 0.0}, {20'000.0, 0.0}}, {true, false, false, true}};
};

TEST_F(LegsWithAHold, TakeAsLongAsTheEarliestSchedule) {
  const cost::Sea sea = this->sea();
  const auto schedule = cost::schedule_along(sea, route_.points, cost::at_departure);
  ASSERT_TRUE(schedule);
  ASSERT_GT(schedule->waits[2].count(), hour_s);
  const HeldLegs legs{sea, route_, *schedule};

  core::Seconds now{0.0};
  for (std::size_t i = 1; i < route_.points.size(); ++i) {
    const auto time = legs(route_.points[i - 1], route_.points[i], now);
    ASSERT_TRUE(time);
    now += *time;
  }

  EXPECT_NEAR(now.count(), schedule->arrivals.back().count(), 10.0);
}

TEST_F(LegsWithAHold, HoldAboutThePlaceOfTheScheduleAlone) {
  const cost::Sea sea = this->sea();
  const auto schedule = cost::schedule_along(sea, route_.points, cost::at_departure);
  ASSERT_TRUE(schedule);
  const HeldLegs legs{sea, route_, *schedule};
  const geo::PlanePoint goal = route_.points.back();
  const core::Seconds now = schedule->arrivals[2];

  EXPECT_TRUE(legs({8200.0, 100.0}, goal, now));
  EXPECT_FALSE(legs({6000.0, 0.0}, goal, now));
}

}  // namespace
}  // namespace floeplan::planning::publish::held_legs_test
