#include "engine/avoidance/evasive_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/avoidance/collision_watch.hpp"
#include "engine/avoidance/steering.hpp"
#include "tests/support/property.hpp"

namespace floeplan::avoidance::evasive_path_test {
namespace {

/// Water frame and local plane the same, at time 0.
WaterFrame still_frame() {
  WaterFrame water;
  water.step(OwnState{});
  return water;
}

EvasivePath plan(const Going& going, geo::PlanePoint goal, const std::vector<Obstacle>& obstacles,
                 AvoidanceSettings settings = {}) {
  return plan_evasion(going, goal, still_frame(), obstacles, settings, {});
}

double length_m(const TimedWay& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.points().size(); ++i)
    sum += distance_m(way.points()[i - 1].place, way.points()[i].place);
  return sum;
}

TEST(EvasivePath, IsStraightWhereNothingIsInTheWay) {
  const EvasivePath path = plan({{0.0, 0.0}, 10.0, 0.35, {}}, {400.0, 100.0}, {});
  ASSERT_EQ(path.way.points().size(), 2U);
  EXPECT_NEAR(path.way.points()[1].time_s, 10.0 + std::hypot(400.0, 100.0) / 0.35, 1e-6);
}

/// Compared with the shortest path round a disc: two tangents and the arc between them.
TEST(EvasivePath, GoesRoundADiscByLittleMoreThanTheShortestWay) {
  constexpr double radius_m = 60.0;
  const AvoidanceSettings settings;
  const EvasivePath path =
      plan({{0.0, 0.0}, 0.0, 0.35, {}}, {400.0, 0.0}, {{{200.0, 0.0}, {}, radius_m, 0.0, false}});
  const double r = radius_m + settings.clearance.value;
  const double shortest = 2.0 * (std::sqrt(200.0 * 200.0 - r * r) + r * std::asin(r / 200.0));
  ASSERT_FALSE(path.way.empty());
  EXPECT_GE(length_m(path.way), shortest);
  EXPECT_LE(length_m(path.way), 1.06 * shortest);
}

/// Law: at its own times the path touches no obstacle, needs no more than the speed of the vehicle, and ends
/// at the goal.
TEST(EvasivePath, TouchesNothingAtTheTimesItStates) {
  int found = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const auto any = [&](double most) { return support::uniform(rng, -most, most); };
    std::vector<Obstacle> bergs;
    for (int i = 0; i < 4; ++i) {
      bergs.push_back({{250.0 + any(180.0), any(150.0)},
                       {any(0.12), any(0.12)},
                       support::uniform(rng, 10.0, 60.0),
                       0.0,
                       false});
    }
    const Going going{{0.0, 0.0}, 1000.0, 0.35, {{any(0.1)}, {any(0.1)}}};
    const geo::PlanePoint goal{500.0, any(100.0)};
    const EvasivePath path = plan(going, goal, bergs);
    if (path.way.empty()) return;
    ++found;

    const auto points = path.way.points();
    EXPECT_FALSE(first_contact(points, bergs, AvoidanceSettings{}.clearance.value));
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_NEAR(distance_m(points[i - 1].place, points[i].place),
                  0.35 * (points[i].time_s - points[i - 1].time_s), 1e-6);
    }
    const double since_s = points.back().time_s - 1000.0;
    EXPECT_NEAR(points.back().place.x_m + since_s * going.current.east.value, goal.x_m, 1e-6);
    EXPECT_NEAR(points.back().place.y_m + since_s * going.current.north.value, goal.y_m, 1e-6);
  });
  EXPECT_GE(found, 30);
}

TEST(EvasivePath, LeavesAHollowByItsMouth) {
  std::vector<Obstacle> hollow;
  for (double along = 0.0; along <= 120.0; along += 6.0) {
    hollow.push_back({{80.0, along - 60.0}, {}, 4.5, 0.0, false});
    hollow.push_back({{80.0 - along, 60.0}, {}, 4.5, 0.0, false});
    hollow.push_back({{80.0 - along, -60.0}, {}, 4.5, 0.0, false});
  }
  const EvasivePath path = plan({{30.0, 0.0}, 0.0, 0.35, {}}, {250.0, 0.0}, hollow);
  ASSERT_FALSE(path.way.empty());
  EXPECT_GT(length_m(path.way), 350.0);
}

TEST(EvasivePath, SaysWhenItsBudgetIsSpent) {
  AvoidanceSettings settings;
  settings.most_expansions = 1;
  std::vector<Obstacle> wall;  // across the whole grid: the search looks everywhere before it
  for (double y = -300.0; y <= 300.0; y += 6.0) wall.push_back({{200.0, y}, {}, 4.5, 0.0, false});
  const EvasivePath path = plan({{0.0, 0.0}, 0.0, 0.35, {}}, {400.0, 0.0}, wall, settings);
  EXPECT_TRUE(path.out_of_budget);
  EXPECT_TRUE(path.way.empty());
  // The stop is checked after this many expansions, as in all searches of the planner.
  EXPECT_LE(path.expansions, 1024);
}

TEST(EvasivePath, EndsWhenItIsToldTo) {
  std::stop_source stop;
  stop.request_stop();
  const EvasivePath path =
      plan_evasion({{0.0, 0.0}, 0.0, 0.35, {}}, {400.0, 0.0}, still_frame(), {}, {}, stop.get_token());
  EXPECT_TRUE(path.out_of_budget);
  EXPECT_TRUE(path.way.empty());
}

}  // namespace
}  // namespace floeplan::avoidance::evasive_path_test
