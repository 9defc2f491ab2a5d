#include "engine/avoidance/mission_route.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/avoidance/goal_point.hpp"

namespace floeplan::avoidance::mission_route_test {
namespace {

OwnState own_at(double x, double y) {
  OwnState own;
  own.time = core::from_unix_seconds(0.0);
  own.place = {x, y};
  return own;
}

MissionRoute route_east() { return {{{1000.0, 0.0}, {2000.0, 0.0}}, core::Metres{50.0}}; }

TEST(MissionRoute, RefusesMissionsWithoutAUsableWaypoint) {
  EXPECT_THROW((MissionRoute{{}, core::Metres{50.0}}), std::invalid_argument);
  EXPECT_THROW((MissionRoute{{{std::nan(""), 0.0}}, core::Metres{50.0}}), std::invalid_argument);
}

TEST(MissionRoute, CountsWaypointsWithinReachAndNeverBack) {
  MissionRoute route = route_east();
  route.visit({0.0, 0.0});
  EXPECT_EQ(route.next(), 0U);
  route.visit({960.0, 10.0});
  EXPECT_EQ(route.next(), 1U);
  route.skip_to(0);
  EXPECT_EQ(route.next(), 1U);
  EXPECT_NEAR(route.to_go_m({1500.0, 0.0}), 500.0, 1e-9);
  route.visit({2000.0, 0.0});
  EXPECT_TRUE(route.is_done());
}

/// A vehicle that crabs against a cross current moves straight through the water, upstream of its course.
TEST(MissionRoute, WayInTheWaterIsAsLongAsTheVehicleSwims) {
  MissionRoute route = route_east();
  WaterFrame water;
  water.step(own_at(0.0, 0.0));
  const Going going{{0.0, 0.0}, 0.0, 0.35, {{0.0}, {0.2}}};
  const TimedWay way = route.way(going, water, 1000.0);
  ASSERT_EQ(way.points().size(), 2U);
  const TimedPoint end = way.points()[1];
  EXPECT_NEAR(end.time_s, 1000.0, 1e-9);
  EXPECT_NEAR(end.place.y_m, -200.0, 1e-9);
  EXPECT_NEAR(std::hypot(end.place.x_m, end.place.y_m), 350.0, 1e-9);
}

TEST(Rendezvous, LiesOnTheRouteBehindTheObstacle) {
  MissionRoute route = route_east();
  route.visit({0.0, 0.0});
  WaterFrame water;
  water.step(own_at(0.0, 0.0));
  const Going going{{100.0, 5.0}, 0.0, 0.35, {}};
  const std::vector<Obstacle> berg{{{300.0, 0.0}, {}, 60.0, 0.0, false}};
  const auto goal = rendezvous(route, going, water, berg, AvoidanceSettings{}, 0.0);
  ASSERT_TRUE(goal);
  EXPECT_NEAR(goal->place.y_m, 0.0, 1e-9);
  EXPECT_GT(goal->place.x_m, 300.0 + 60.0 + 30.0);
  EXPECT_LT(goal->place.x_m, 300.0 + 60.0 + 30.0 + 60.0);
  EXPECT_EQ(goal->waypoint, 0U);
}

TEST(Rendezvous, IsNoneWhileTheRouteEndsInAnObstacle) {
  const MissionRoute route{{{300.0, 0.0}}, core::Metres{50.0}};
  WaterFrame water;
  water.step(own_at(0.0, 0.0));
  const std::vector<Obstacle> berg{{{300.0, 0.0}, {}, 60.0, 0.0, false}};
  EXPECT_FALSE(rendezvous(route, {{100.0, 0.0}, 0.0, 0.35, {}}, water, berg, AvoidanceSettings{}, 200.0));
}

TEST(Rendezvous, WaitsForNoBergThatWillBeGone) {
  const MissionRoute route{{{900.0, 0.0}}, core::Metres{50.0}};
  WaterFrame water;
  water.step(own_at(0.0, 0.0));
  const std::vector<Obstacle> leaving{{{300.0, 0.0}, {0.0, 0.3}, 60.0, 0.0, false}};
  const auto goal =
      rendezvous(route, {{0.0, 0.0}, 0.0, 0.35, {}}, water, leaving, AvoidanceSettings{}, 300.0);
  ASSERT_TRUE(goal);
  EXPECT_NEAR(goal->place.x_m, 300.0, 1e-9);
}

}  // namespace
}  // namespace floeplan::avoidance::mission_route_test
