#include "engine/planning/refinement/longer_legs.hpp"

#include <gtest/gtest.h>

namespace floeplan::planning::refinement::longer_legs_test {
namespace {

constexpr double speed_m_s = 0.5;

/// Still water with a thick wall across, which a leg passes in a gate only.
struct StillWater {
  double gate_from_y{};
  double gate_until_y{};

  std::optional<core::Seconds> operator()(geo::PlanePoint a, geo::PlanePoint b, core::Seconds) const {
    for (const double wall_x : {19'600.0, 20'400.0}) {
      if (a.x_m > wall_x || b.x_m < wall_x) continue;
      const double y = a.y_m + (wall_x - a.x_m) / (b.x_m - a.x_m) * (b.y_m - a.y_m);
      if (y < gate_from_y || y > gate_until_y) return std::nullopt;
    }
    return core::Seconds{geo::distance_m(a, b) / speed_m_s};
  }
};

cost::Route route(std::vector<geo::PlanePoint> points) {
  cost::Route result{std::move(points), {}};
  result.fixed.assign(result.points.size(), false);
  result.fixed.front() = result.fixed.back() = true;
  return result;
}

/// 40 km with a leg of 1 km in its middle, which goes a little round.
cost::Route with_a_short_leg() {
  return route({{0.0, 0.0}, {19'500.0, 1000.0}, {20'500.0, 1000.0}, {40'000.0, 0.0}});
}

const auto as_it_is = [](cost::Itinerary timed) { return timed; };

TEST(ShortLegs, AreThoseBelowThreeKilometresTheShortestFirst) {
  EXPECT_EQ(short_legs(route({{0.0, 0.0}, {2900.0, 0.0}, {37'500.0, 0.0}, {40'000.0, 0.0}})),
            (std::vector<std::size_t>{2, 0}));
}

TEST(ShortLegs, AreThoseBelowAFifthWhereTheDistanceIsShort) {
  EXPECT_EQ(short_legs(route({{0.0, 0.0}, {900.0, 0.0}, {2000.0, 0.0}, {5000.0, 0.0}})),
            (std::vector<std::size_t>{0}));
}

TEST(ShortLegs, AreMeasuredBetweenTheStopsOnBothSides) {
  cost::Route to_and_from = route({{0.0, 0.0}, {2000.0, 0.0}, {4000.0, 0.0}, {40'000.0, 0.0}});
  to_and_from.fixed[2] = true;

  EXPECT_EQ(short_legs(to_and_from), std::vector<std::size_t>{}) << "4 km to the stop, 36 km from it";
}

TEST(WithoutShortLegs, GoesALittleFartherForLongerLegs) {
  const StillWater water{.gate_from_y = 999.0, .gate_until_y = 5000.0};
  LegMeter legs{water, {}};
  const auto timed = legs.timed(with_a_short_leg(), cost::at_departure);
  ASSERT_TRUE(timed);

  const cost::Itinerary longer = without_short_legs(legs, *timed, 1.005 * timed->cost(), as_it_is);

  EXPECT_EQ(longer.route.legs(), 2U);
  EXPECT_TRUE(short_legs(longer.route).empty());
  EXPECT_GT(longer.cost(), timed->cost());
  EXPECT_LE(longer.cost(), 1.005 * timed->cost());
  EXPECT_EQ(without_short_legs(legs, *timed, timed->cost(), as_it_is).route.legs(), 3U)
      << "nothing may be given";
}

TEST(WithoutShortLegs, KeepsALegWhereEveryOtherRouteIsClosed) {
  const StillWater water{.gate_from_y = 999.0, .gate_until_y = 1001.0};
  LegMeter legs{water, {}};
  const auto timed = legs.timed(with_a_short_leg(), cost::at_departure);
  ASSERT_TRUE(timed);

  EXPECT_EQ(without_short_legs(legs, *timed, 2.0 * timed->cost(), as_it_is).route.legs(), 3U);
}

}  // namespace
}  // namespace floeplan::planning::refinement::longer_legs_test
