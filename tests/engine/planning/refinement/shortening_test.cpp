#include "engine/planning/refinement/shortening.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tl/expected.hpp>

#include "engine/motion/edge_closed.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::refinement::shortening_test {
namespace {

using Leg = tl::expected<core::Seconds, motion::EdgeClosed>;

/// Legs take a second per metre. A square of 200 m around (500, 0) is closed.
Leg around_a_square(geo::PlanePoint a, geo::PlanePoint b, core::Seconds) {
  constexpr int looks = 500;
  for (int i = 0; i <= looks; ++i) {
    const double share = static_cast<double>(i) / looks;
    const double x_m = a.x_m + share * (b.x_m - a.x_m);
    const double y_m = a.y_m + share * (b.y_m - a.y_m);
    if (std::abs(x_m - 500.0) < 100.0 && std::abs(y_m) < 100.0)
      return tl::unexpected(motion::EdgeClosed::obstacle);
  }
  return core::Seconds{geo::distance_m(a, b)};
}

/// A route that passes the upper corners of the square closely.
cost::Route round_two_corners(double off_m) {
  return {{{0.0, 0.0}, {400.0 - off_m, 100.0 + off_m}, {600.0 + off_m, 100.0 + off_m}, {1000.0, 0.0}},
          {true, false, false, true}};
}

TEST(Shortening, MergesTwoPointsOfWhichNoneCanGo) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    LegMeter legs{around_a_square, RefinementBudget{}};
    const auto two = legs.timed(round_two_corners(support::uniform(rng, 1.0, 30.0)), core::Seconds{0.0});
    ASSERT_TRUE(two.has_value());
    ASSERT_EQ(thin_to(legs, *two, 2).route.legs(), 3U);

    const cost::Itinerary one = shorten_to(legs, *two, 2);

    ASSERT_EQ(one.route.legs(), 2U);
    EXPECT_TRUE(legs.timed(one.route, core::Seconds{0.0}).has_value()) << "it stays open";
    EXPECT_EQ(one.route.points.front(), two->route.points.front());
    EXPECT_EQ(one.route.points.back(), two->route.points.back());
    EXPECT_LT(one.cost(), 1.1 * two->cost());
  });
}

TEST(Shortening, MovesNoFixedPointAndEndsWhereNothingIsOpen) {
  LegMeter legs{around_a_square, RefinementBudget{}};
  cost::Route route = round_two_corners(10.0);
  route.fixed[1] = true;
  const cost::Itinerary with_via = *legs.timed(route, core::Seconds{0.0});
  const cost::Itinerary two = *legs.timed(round_two_corners(10.0), core::Seconds{0.0});

  EXPECT_EQ(shorten_to(legs, with_via, 1).route.points[1], route.points[1]);
  EXPECT_EQ(shorten_to(legs, two, 1).route.points, two.route.points) << "the straight way is closed";
}

TEST(Shortening, TakesOutWhatIsNotNeededFirst) {
  LegMeter legs{around_a_square, RefinementBudget{}};
  cost::Route route = round_two_corners(10.0);
  route.points.insert(route.points.begin() + 1, {200.0, 90.0});
  route.fixed.insert(route.fixed.begin() + 1, false);
  const cost::Itinerary timed = *legs.timed(route, core::Seconds{0.0});

  const cost::Itinerary three = shorten_to(legs, timed, 3);

  EXPECT_EQ(three.route.points, round_two_corners(10.0).points);
}

TEST(Shortening, LooksWhereTheLegsWouldMeet) {
  const auto places = places_for_both({0.0, 0.0}, {4.0, 2.0}, {6.0, 2.0}, {10.0, 0.0});

  ASSERT_FALSE(places.empty());
  EXPECT_NEAR(places.front().x_m, 5.0, 1e-9);
  EXPECT_NEAR(places.front().y_m, 2.5, 1e-9);
}

TEST(Shortening, FindsNoPlaceOutwardsForAWayThatComesBackToWhereItBegan) {
  for (const geo::PlanePoint place : places_for_both({0.0, 0.0}, {4.0, 2.0}, {6.0, 2.0}, {0.0, 0.0})) {
    EXPECT_TRUE(std::isfinite(place.x_m) && std::isfinite(place.y_m));
  }
}

}  // namespace
}  // namespace floeplan::planning::refinement::shortening_test
