#include "engine/planning/leg_descent.hpp"

#include <gtest/gtest.h>

#include "tests/engine/planning/paper_waters.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning {
namespace {

using geo::PlanePoint;

TimedRoute timed(const std::vector<PlanePoint>& points, const LegTime& leg_time) {
  return time_route(points, core::Seconds{0.0}, leg_time).value();
}

const MeanderingJet jet;
const LegTime in_the_jet = legs_in(jet, along_the_jet.through_water);

TEST(LegDescent, StraightensADetourThroughStillWater) {
  const LegTime still = [](PlanePoint a, PlanePoint b, core::Seconds) {
    return std::optional{core::Seconds{std::hypot(b.x_m - a.x_m, b.y_m - a.y_m)}};
  };
  support::for_each_seed(50, [&](std::mt19937_64& rng) {
    std::vector<PlanePoint> points{{0.0, 0.0}};
    for (int i = 1; i < 12; ++i) points.push_back({100.0 * i, support::uniform(rng, -40.0, 40.0)});
    points.push_back({1200.0, 0.0});

    const Descent descent = descend(timed(points, still), still);

    EXPECT_TRUE(descent.converged);
    EXPECT_NEAR(descent.route.duration().count(), 1200.0, 1e-5);
    EXPECT_EQ(descent.route.points.size(), points.size());
    EXPECT_EQ(descent.route.points.front(), points.front());
    EXPECT_EQ(descent.route.points.back(), points.back());
  });
}

TEST(LegDescent, NeverEndsLaterThanItStarted) {
  support::for_each_seed(4, [](std::mt19937_64& rng) {
    std::vector<PlanePoint> points = ways_along_the_jet(1).front();
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      points[i].x_m += support::uniform(rng, -0.1, 0.1);
      points[i].y_m += support::uniform(rng, -0.1, 0.1);
    }
    const auto start = time_route(points, core::Seconds{0.0}, in_the_jet);
    if (!start) return;  // a current too strong for one of the legs

    const Descent descent = descend(*start, in_the_jet);

    EXPECT_LE(descent.route.duration(), start->duration());
    const auto again = time_route(descent.route.points, core::Seconds{0.0}, in_the_jet);
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->times, descent.route.times);
  });
}

TEST(LegDescent, LeavesNothingToGainAcrossTheWay) {
  const TimedRoute start = timed(ways_along_the_jet(1).front(), in_the_jet);

  const Descent descent = descend_with_legs(descend(start, in_the_jet).route, 64, in_the_jet);

  ASSERT_TRUE(descent.converged);
  support::for_each_seed(100, [&](std::mt19937_64& rng) {
    std::vector<PlanePoint> points = descent.route.points;
    const auto i = static_cast<std::size_t>(support::uniform_int(rng, 1, 63));
    const double size = support::uniform(rng, -0.05, 0.05);
    const double dx = points[i + 1].x_m - points[i - 1].x_m;
    const double dy = points[i + 1].y_m - points[i - 1].y_m;
    points[i].x_m -= size * dy / std::hypot(dx, dy);
    points[i].y_m += size * dx / std::hypot(dx, dy);
    const auto moved = time_route(points, core::Seconds{0.0}, in_the_jet);
    if (!moved) return;  // closed by a strong current
    EXPECT_GT(moved->duration().count(), descent.route.duration().count() - 2e-5);
  });
}

TEST(LegDescent, ErrsWithTheSquareOfALegsLength) {
  constexpr double optimum = 17.1588;  // by collocation
  const TimedRoute start = descend(timed(ways_along_the_jet(1).front(), in_the_jet), in_the_jet).route;

  const double with_64 = descend_with_legs(start, 64, in_the_jet).route.duration().count();
  const double with_128 = descend_with_legs(start, 128, in_the_jet).route.duration().count();

  EXPECT_NEAR((with_64 - optimum) / (with_128 - optimum), 4.0, 0.1);
}

TEST(LegDescent, SaysThatItDidNotConvergeWhenStopped) {
  std::stop_source source;
  source.request_stop();
  const TimedRoute start = timed(ways_along_the_jet(1).front(), in_the_jet);

  const Descent descent = descend(start, in_the_jet, source.get_token());

  EXPECT_FALSE(descent.converged);
  EXPECT_EQ(descent.route.points, start.points);
}

}  // namespace
}  // namespace floeplan::planning
