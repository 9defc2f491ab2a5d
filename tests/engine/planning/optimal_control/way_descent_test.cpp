#include "engine/planning/optimal_control/way_descent.hpp"

#include <gtest/gtest.h>

#include "tests/engine/planning/paper_waters.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::optimal_control::way_descent_test {
namespace {

using geo::PlanePoint;

TimedWay timed(const std::vector<PlanePoint>& points, const LegTimer& leg_timer) {
  return time_way(points, core::Seconds{0.0}, leg_timer).value();
}

const currents::MeanderingJet jet;
const LegTimer in_the_jet = legs_in(jet, along_the_jet.through_water);

TEST(WayDescent, StraightensADetourThroughStillWater) {
  const LegTimer still = [](PlanePoint a, PlanePoint b, core::Seconds) {
    return std::optional{core::Seconds{std::hypot(b.x_m - a.x_m, b.y_m - a.y_m)}};
  };
  support::for_each_seed(50, [&](std::mt19937_64& rng) {
    std::vector<PlanePoint> points{{0.0, 0.0}};
    for (int i = 1; i < 12; ++i) points.push_back({100.0 * i, support::uniform(rng, -40.0, 40.0)});
    points.push_back({1200.0, 0.0});

    const WayDescent descent = descend(timed(points, still), still);

    EXPECT_TRUE(descent.converged);
    EXPECT_NEAR(descent.way.duration().count(), 1200.0, 1e-7 * 1200.0);
    EXPECT_EQ(descent.way.points.size(), points.size());
    EXPECT_EQ(descent.way.points.front(), points.front());
    EXPECT_EQ(descent.way.points.back(), points.back());
  });
}

TEST(WayDescent, NeverEndsLaterThanItStarted) {
  support::for_each_seed(4, [](std::mt19937_64& rng) {
    std::vector<PlanePoint> points = ways_along_the_jet(1).front();
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      points[i].x_m += support::uniform(rng, -0.1, 0.1);
      points[i].y_m += support::uniform(rng, -0.1, 0.1);
    }
    const auto start = time_way(points, core::Seconds{0.0}, in_the_jet);
    if (!start) return;  // a current too strong for one of the legs

    const WayDescent descent = descend(*start, in_the_jet);

    EXPECT_LE(descent.way.duration(), start->duration());
    const auto again = time_way(descent.way.points, core::Seconds{0.0}, in_the_jet);
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->times, descent.way.times);
  });
}

TEST(WayDescent, LeavesNothingToGainAcrossTheWay) {
  const TimedWay start = timed(ways_along_the_jet(1).front(), in_the_jet);

  const WayDescent descent = descend_with_legs(descend(start, in_the_jet).way, 64, in_the_jet);

  ASSERT_TRUE(descent.converged);
  support::for_each_seed(100, [&](std::mt19937_64& rng) {
    std::vector<PlanePoint> points = descent.way.points;
    const auto i = static_cast<std::size_t>(support::uniform_int(rng, 1, 63));
    const double size = support::uniform(rng, -0.05, 0.05);
    const double dx = points[i + 1].x_m - points[i - 1].x_m;
    const double dy = points[i + 1].y_m - points[i - 1].y_m;
    points[i].x_m -= size * dy / std::hypot(dx, dy);
    points[i].y_m += size * dx / std::hypot(dx, dy);
    const auto moved = time_way(points, core::Seconds{0.0}, in_the_jet);
    if (!moved) return;  // closed by a strong current
    EXPECT_GT(moved->duration().count(), descent.way.duration().count() - 2e-5);
  });
}

TEST(WayDescent, ErrsWithTheSquareOfALegsLength) {
  constexpr double optimum = 17.1588;  // by collocation
  const TimedWay start = descend(timed(ways_along_the_jet(1).front(), in_the_jet), in_the_jet).way;

  const double with_64 = descend_with_legs(start, 64, in_the_jet).way.duration().count();
  const double with_128 = descend_with_legs(start, 128, in_the_jet).way.duration().count();

  EXPECT_NEAR((with_64 - optimum) / (with_128 - optimum), 4.0, 0.1);
}

TEST(WayDescent, SaysThatItDidNotConvergeWhenStopped) {
  std::stop_source source;
  source.request_stop();
  const TimedWay start = timed(ways_along_the_jet(1).front(), in_the_jet);

  const WayDescent descent = descend(start, in_the_jet, source.get_token());

  EXPECT_FALSE(descent.converged);
  EXPECT_EQ(descent.way.points, start.points);
}

}  // namespace
}  // namespace floeplan::planning::optimal_control::way_descent_test
