#include "engine/planning/refinement/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tl/expected.hpp>

#include "engine/motion/edge_closed.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::refinement::thinning_test {
namespace {

using Leg = tl::expected<core::Seconds, motion::EdgeClosed>;

/// Legs take a second per metre. The disc of 100 m around (500, 0) is closed.
Leg around_a_disc(geo::PlanePoint a, geo::PlanePoint b, core::Seconds) {
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  const double length2 = dx * dx + dy * dy;
  const double along =
      length2 > 0.0 ? std::clamp(((500.0 - a.x_m) * dx - a.y_m * dy) / length2, 0.0, 1.0) : 0.0;
  if (std::hypot(a.x_m + along * dx - 500.0, a.y_m + along * dy) <= 100.0) {
    return tl::unexpected(motion::EdgeClosed::obstacle);
  }
  return core::Seconds{std::sqrt(length2)};
}

cost::Route random_arc(std::mt19937_64& rng) {
  cost::Route route;
  for (int i = 0; i <= 10; ++i) {
    route.points.push_back({100.0 * i, i % 10 == 0 ? 0.0 : support::uniform(rng, 150.0, 250.0)});
    route.fixed.push_back(i % 10 == 0 || i == 3);
  }
  return route;
}

TEST(Thinning, CutsToTheNumberAskedForAsFarAsFixedPointsAndObstaclesLet) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    LegMeter legs{around_a_disc, RefinementBudget{}};
    const cost::Itinerary arc = *legs.timed(random_arc(rng), core::Seconds{0.0});

    const cost::Itinerary five = thin_to(legs, arc, 5);
    const cost::Itinerary fewest = thin_to(legs, arc, 1);

    EXPECT_EQ(five.route.legs(), 5U);
    EXPECT_GE(fewest.route.legs(), 2U) << "start, via and goal stay";
    EXPECT_EQ(std::ranges::count(fewest.route.fixed, true), 3);
    EXPECT_TRUE(legs.timed(fewest.route, core::Seconds{0.0}).has_value()) << "it stays open";
  });
}

TEST(Thinning, SplitsTheLongestLegsAndKeepsTheWay) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    LegMeter legs{around_a_disc, RefinementBudget{}};
    const cost::Itinerary arc = *legs.timed(random_arc(rng), core::Seconds{7.0});

    const cost::Itinerary split = split_to(legs, arc, 37);

    EXPECT_EQ(split.route.legs(), 37U);
    EXPECT_EQ(std::ranges::count(split.route.fixed, true), std::ranges::count(arc.route.fixed, true));
    EXPECT_NEAR(split.arrival().count(), arc.arrival().count(), 1e-9);
    std::vector<double> durations;
    for (std::size_t i = 1; i < split.times.size(); ++i)
      durations.push_back((split.times[i] - split.times[i - 1]).count());
    EXPECT_LE(std::ranges::max(durations), 2.0 * std::ranges::min(durations));
  });
}

TEST(Thinning, LeavesALegWholeThatIsClosedInPieces) {
  const auto closed_around_the_middle = [](geo::PlanePoint a, geo::PlanePoint b, core::Seconds) -> Leg {
    if (a.x_m == 50.0 || b.x_m == 50.0) return tl::unexpected(motion::EdgeClosed::obstacle);
    return core::Seconds{b.x_m - a.x_m};
  };
  LegMeter legs{closed_around_the_middle, RefinementBudget{}};
  const cost::Route route{{{0.0, 0.0}, {100.0, 0.0}, {200.0, 0.0}}, {true, false, true}};

  const cost::Itinerary split = split_to(legs, *legs.timed(route, core::Seconds{0.0}), 4);

  EXPECT_EQ(split.route.points,
            (std::vector<geo::PlanePoint>{{0.0, 0.0}, {100.0, 0.0}, {150.0, 0.0}, {200.0, 0.0}}));
}

}  // namespace
}  // namespace floeplan::planning::refinement::thinning_test
