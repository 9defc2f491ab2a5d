#include "engine/planning/cost/route_grid.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace floeplan::planning::cost::route_grid_test {
namespace {

TEST(RouteGrid, HasStartAndGoalAmongItsVertices) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    std::uniform_real_distribution<double> coordinate{-1e5, 1e5};
    std::uniform_real_distribution<double> step{200.0, 5000.0};
    const geo::PlanePoint start{coordinate(rng), coordinate(rng)};
    const geo::PlanePoint goal{coordinate(rng), coordinate(rng)};

    const RouteGrid grid = lay_grid(start, goal, {core::Metres{step(rng)}, core::Metres{step(rng)}}, {});

    EXPECT_NEAR(grid.point(grid.start).x_m, start.x_m, 1e-6);
    EXPECT_NEAR(grid.point(grid.start).y_m, start.y_m, 1e-6);
    EXPECT_NEAR(grid.point(grid.goal).x_m, goal.x_m, 1e-6);
    EXPECT_NEAR(grid.point(grid.goal).y_m, goal.y_m, 1e-6);
    EXPECT_TRUE(grid.bounds().contains(start));
    EXPECT_TRUE(grid.bounds().contains(goal));
  });
}

TEST(RouteGrid, LeavesRoomToGoRoundSomethingOnAShortWay) {
  const RouteGrid grid = lay_grid({0.0, 0.0}, {100.0, 0.0}, {core::Metres{50.0}, core::Metres{50.0}}, {});

  EXPECT_LE(grid.bounds().low.y_m, -500.0);
  EXPECT_GE(grid.bounds().high.x_m, 600.0);
}

TEST(RouteGrid, ReachesAsFarAsItMustHoweverShortTheWay) {
  const GridReach reach{.across = 1.0, .beyond = 0.75, .at_least = core::Metres{15'000.0}};
  const auto room_m = [&](double spacing_m) {
    const core::Metres spacing{spacing_m};
    return lay_grid({0.0, 0.0}, {2'000.0, 0.0}, {spacing, spacing}, reach).bounds().high.y_m;
  };

  EXPECT_NEAR(room_m(250.0), 15'000.0, 250.0);
  EXPECT_NEAR(room_m(10.0), GridReach::most_steps_of_least * 10.0, 10.0) << "a fine grid stays bounded";
}

TEST(RouteGrid, LiesRoundThePlaceWhereStartAndGoalAreOne) {
  const RouteGrid grid = lay_grid({3.0, 4.0}, {3.0, 4.0}, {core::Metres{50.0}, core::Metres{20.0}}, {});

  EXPECT_EQ(grid.start, grid.goal);
  EXPECT_NEAR(grid.point(grid.start).x_m, 3.0, 1e-9);
  EXPECT_NEAR(grid.point(grid.start).y_m, 4.0, 1e-9);
  EXPECT_LE(grid.bounds().low.x_m, 3.0 - 500.0);
  EXPECT_GE(grid.bounds().high.y_m, 4.0 + 200.0);
}

}  // namespace
}  // namespace floeplan::planning::cost::route_grid_test
