#include "engine/planning/publish/holds_for_legs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/refinement/longer_legs.hpp"
#include "tests/engine/planning/publish/berg_across.hpp"

namespace floeplan::planning::publish::holds_for_legs_test {
namespace {

class HoldsForShortLegs : public BergAcross {
 protected:
  static core::Seconds arrival(const cost::Sea& sea, const cost::Route& route) {
    return cost::arrivals_along(sea, route.points, cost::at_departure).value().back();
  }
};

/// To and fro between two places before the berg, as often as it takes to let the berg drift by.
cost::Route to_and_fro(int times) {
  cost::Route route{{{0.0, 0.0}}, {true}};
  for (int i = 0; i < times; ++i) {
    route.points.insert(route.points.end(), {{6000.0, 0.0}, {6400.0, 800.0}});
    route.fixed.insert(route.fixed.end(), {false, false});
  }
  route.points.push_back({20'000.0, 0.0});
  route.fixed.push_back(true);
  return route;
}

TEST_F(HoldsForShortLegs, GiveWayToAHoldThatArrivesAboutAsEarly) {
  const cost::Sea sea = this->sea();
  const cost::Route route = to_and_fro(5);
  ASSERT_FALSE(refinement::short_legs(route).empty());

  const cost::Route held = with_holds_for_short_legs(sea, route, {});

  EXPECT_TRUE(refinement::short_legs(held).empty());
  const auto before = cost::arrivals_along(sea, route.points, cost::at_departure).value();
  const core::Seconds to_and_fro_takes = before[before.size() - 2] - before[1];
  EXPECT_LE(arrival(sea, held), before.back() + 0.5 * to_and_fro_takes);
  const auto waits = cost::schedule_along(sea, held.points, cost::at_departure).value().waits;
  EXPECT_GT(std::ranges::max(waits).count(), hour_s);
}

TEST_F(HoldsForShortLegs, StayWhereTheirPlacesAreFixed) {
  const cost::Sea sea = this->sea();
  cost::Route route = to_and_fro(2);
  route.fixed.assign(route.points.size(), true);

  EXPECT_EQ(with_holds_for_short_legs(sea, route, {}).points.size(), route.points.size());
}

TEST_F(HoldsForShortLegs, NeverGiveWayToARouteThatIsClosedOrLaterByMoreThanTheirTime) {
  const cost::Sea sea = this->sea();
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    cost::Route route{{{0.0, 0.0}}, {true}};
    for (int i = 0; i < 6; ++i) {
      route.points.push_back(
          {support::uniform(rng, 4000.0, 16'000.0), support::uniform(rng, -6000.0, 6000.0)});
      route.fixed.push_back(rng() % 6 == 0);
    }
    std::ranges::sort(route.points, {}, &geo::PlanePoint::x_m);
    route.points.push_back({20'000.0, 0.0});
    route.fixed.push_back(true);
    const auto before = cost::arrivals_along(sea, route.points, cost::at_departure);
    if (!before) return;

    const cost::Route held = with_holds_for_short_legs(sea, route, {});

    core::Seconds on_short_legs{0.0};
    for (const std::size_t i : refinement::short_legs(route))
      on_short_legs += (*before)[i + 1] - (*before)[i];
    EXPECT_LE(arrival(sea, held), before->back() + on_short_legs);
    EXPECT_LE(refinement::short_legs(held).size(), refinement::short_legs(route).size());
    EXPECT_EQ(std::ranges::count(held.fixed, true), std::ranges::count(route.fixed, true));
  });
}

}  // namespace
}  // namespace floeplan::planning::publish::holds_for_legs_test
