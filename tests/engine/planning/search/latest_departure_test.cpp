#include "engine/planning/search/latest_departure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/messages/sentence.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_arrival.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/voyage_grids.hpp"
#include "engine/planning/search/voyage_search.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::latest_departure_test {
namespace {

using support::currents_from;

PlanRequest coarse_request() {
  PlanRequest request = support::eastward_request();
  request.spacing_along = core::Metres{2000.0};
  request.optimality_gap = false;
  return request;
}

PlanRequest arriving_after(double hours) {
  PlanRequest request = coarse_request();
  request.departures.arrive_by = request.depart + core::Seconds{3600.0 * hours};
  return request;
}

ocean::Environment random_tide(std::mt19937_64& rng, int hours) {
  const double phase = support::uniform(rng, 0.0, 6.28);
  const double strength_m_s = support::uniform(rng, 0.1, 0.25);
  return {.currents = currents_from(
              [&](geo::LonLat p, double hour) {
                return geo::VelocityEn{{strength_m_s * std::cos(hour / 2.0 + phase)},
                                       {strength_m_s * std::sin(hour / 3.0 + 4.0 * p.lon_deg)}};
              },
              hours)};
}

TEST(LatestDeparture, ArrivesWhenItWasAskedToAndAnyLaterOneArrivesLater) {
  support::for_each_seed(6, [](std::mt19937_64& rng) {
    PlanRequest request = coarse_request();
    if (support::uniform_int(rng, 0, 1) == 1) request.via = {{-53.1, 69.1}};
    const ocean::Environment environment = random_tide(rng, 200);
    const auto chart = draw_chart(environment, request, cost::first_reach, {});
    ASSERT_TRUE(chart.has_value());
    const auto grids = open_grids(chart->sea, chart->layout.grids, request.sectors, {});
    const core::Seconds wanted{3600.0 * support::uniform(rng, 90.0, 180.0)};

    const auto depart = latest_departure(chart->sea, grids, wanted, core::Seconds{0.0}, {});
    ASSERT_TRUE(depart.has_value());
    const auto arrive = [&](core::Seconds when) {
      return search_voyage(chart->sea, grids, request, when, {}, [](double) {})->arrival;
    };
    const double travel_s = (wanted - *depart).count();

    EXPECT_NEAR(arrive(*depart).count(), wanted.count(), 2e-4 * travel_s);
    EXPECT_GT(arrive(*depart + 1e-3 * (wanted - *depart) + core::Seconds{600.0}), wanted);
  });
}

TEST(LatestDeparture, IsNoneWhenTheEarliestOneComesTooLate) {
  const PlanRequest request = coarse_request();
  const ocean::Environment still_water;
  const auto chart = draw_chart(still_water, request, cost::first_reach, {});
  const auto grids = open_grids(chart->sea, chart->layout.grids, request.sectors, {});

  EXPECT_FALSE(latest_departure(chart->sea, grids, core::Seconds{3600.0}, core::Seconds{0.0}, {}));
}

TEST(PlanArrival, ArrivesInTimeAndHardlyBefore) {
  support::for_each_seed(3, [](std::mt19937_64& rng) {
    const ocean::Environment environment = random_tide(rng, 200);
    const PlanRequest request = arriving_after(support::uniform(rng, 90.0, 180.0));

    const auto plan = plan_arrival(environment, request, {}, {});

    ASSERT_TRUE(plan.has_value()) << plan.error().explanation();
    EXPECT_LE(plan->arrival, *request.departures.arrive_by);
    EXPECT_GT(plan->arrival,
              *request.departures.arrive_by - 2e-3 * plan->travel_time() - core::Seconds{60.0});
  });
}

/// Law: it is the plan for its departure alone, or a route that is a little sooner at the goal.
TEST(PlanArrival, IsAsSoonAtTheGoalAsThePlanForItsDepartureAlone) {
  support::for_each_seed(4, [](std::mt19937_64& rng) {
    const ocean::Environment environment = random_tide(rng, 150);
    PlanRequest request = arriving_after(100.0);
    const auto plan = plan_arrival(environment, request, {}, {});
    ASSERT_TRUE(plan.has_value());

    request.depart = plan->departure;
    request.departures = {};
    const auto alone = plan_route(environment, request, {}, {});

    EXPECT_LE(plan->arrival, alone->arrival);
    EXPECT_GE(plan->travel_time(), (1.0 - request.leg_tolerance - 1e-3) * alone->travel_time());
    if (plan->arrival == alone->arrival) {
      EXPECT_EQ(plan->waypoints.size(), alone->waypoints.size());
    }
  });
}

TEST(PlanArrival, TakesAKnownRouteOnlyIfThatIsSoonerAtTheGoal) {
  support::for_each_seed(4, [](std::mt19937_64& rng) {
    const ocean::Environment environment = random_tide(rng, 200);
    const PlanRequest request = coarse_request();
    const auto found = planner::try_to_plan(environment, request, {}, {});
    ASSERT_TRUE(found.has_value());
    PlanRequest later = request;
    later.depart += core::Seconds{support::uniform(rng, 0.0, 7200.0)};
    std::vector<geo::LonLat> way;
    for (const Waypoint& waypoint : found->waypoints) way.push_back(waypoint.place);
    const auto timed = evaluate_route(environment, way, later, {});
    ASSERT_TRUE(timed.has_value());
    const auto alone = planner::try_to_plan(environment, later, {}, {});
    const std::vector<geo::LonLat> elsewhere{{-53.5, 69.0}, {-53.0, 69.1}};

    const auto plan = planner::try_to_plan(environment, later, {}, {}, core::in_order(), way);

    EXPECT_NEAR((plan->arrival - std::min(timed->arrival, alone->arrival)).count(), 0.0, 1.0);
    const auto of_another_goal =
        planner::try_to_plan(environment, later, {}, {}, core::in_order(), elsewhere);
    EXPECT_EQ(of_another_goal->arrival, alone->arrival);
  });
}

TEST(PlanArrival, CountsTheIcebergsThatAreYoungEnoughForItsDeparture) {
  PlanRequest request = arriving_after(200.0);
  ocean::Iceberg in_the_way = support::iceberg_at({-53.0, 69.0}, 200.0);
  in_the_way.too_old_from = request.depart + core::Seconds{199.0 * 3600.0};
  const auto around = plan_arrival({.icebergs = {in_the_way}}, request, {}, {});
  in_the_way.too_old_from = request.depart + core::Seconds{100.0 * 3600.0};

  const auto through = plan_arrival({.icebergs = {in_the_way}}, request, {}, {});

  ASSERT_TRUE(around && through);
  EXPECT_GT(through->departure, *in_the_way.too_old_from);
  EXPECT_TRUE(around->clearances.iceberg);
  EXPECT_FALSE(through->clearances.iceberg);
  EXPECT_THAT(messages::sentences(around->messages),
              testing::Not(testing::Contains(testing::HasSubstr("left out"))));
  EXPECT_THAT(messages::sentences(through->messages),
              testing::Contains(testing::HasSubstr("Danger: 1 iceberg was ignored")));
}

TEST(PlanArrival, LeavesAtTheStraightLinesTimeInStillWater) {
  PlanRequest request = arriving_after(72.0);
  for (const Method method : {Method::astar, Method::direct}) {
    request.method = method;

    const auto plan = plan_arrival({}, request, {}, {});

    ASSERT_TRUE(plan.has_value());
    EXPECT_LE(plan->arrival, *request.departures.arrive_by);
    EXPECT_NEAR((*request.departures.arrive_by - plan->arrival).count(), 0.0,
                1e-3 * plan->travel_time().count());
  }
}

/// An area round the goal that is closed between two hours.
ocean::Zone closed_goal(const PlanRequest& request, double from_hour, double until_hour) {
  const double west = request.to.lon_deg - 0.05;
  const double south = request.to.lat_deg - 0.02;
  return {.name = "exercise",
          .kind = ocean::ZoneKind::no_go,
          .area = {.outer =
                       {{west, south}, {west + 0.1, south}, {west + 0.1, south + 0.04}, {west, south + 0.04}},
                   .holes = {}},
          .from = request.depart + core::Seconds{3600.0 * from_hour},
          .until = request.depart + core::Seconds{3600.0 * until_hour}};
}

TEST(PlanArrival, ArrivesBeforeTheGoalClosesWhereItIsClosedAtTheWantedTime) {
  for (const double wanted : {121.0, 130.0, 149.0}) {
    PlanRequest request = arriving_after(wanted);
    request.zones = {closed_goal(request, 120.0, 150.0)};

    const auto plan = plan_arrival({}, request, {}, {});

    ASSERT_TRUE(plan.has_value()) << plan.error().explanation();
    const core::UtcTime closes = request.depart + core::Seconds{120.0 * 3600.0};
    EXPECT_LE(plan->arrival, closes);
    EXPECT_GT(plan->arrival, closes - core::Seconds{600.0}) << "to reach " << wanted << " h";
    EXPECT_TRUE(std::ranges::any_of(messages::sentences(plan->messages), [](const std::string& warning) {
      return warning.find("before the wanted arrival") != std::string::npos;
    }));
  }
}

TEST(PlanArrival, LeavesOnceTheStartIsOpen) {
  PlanRequest request = arriving_after(72.0);
  ocean::Zone zone = closed_goal(request, 0.0, 5.0);
  PlanRequest at_start = request;
  at_start.to = request.from;
  zone.area = closed_goal(at_start, 0.0, 0.0).area;
  request.zones = {zone};

  const auto plan = plan_arrival({}, request, {}, {});

  ASSERT_TRUE(plan.has_value()) << plan.error().explanation();
  EXPECT_NEAR((*request.departures.arrive_by - plan->arrival).count(), 0.0,
              1e-3 * plan->travel_time().count());
}

TEST(PlanArrival, IsInTimeInTheShareOfTheMembersThatItIsToBe) {
  const auto stream = [](double speed_m_s) {
    return currents_from([=](geo::LonLat, double) { return geo::VelocityEn{{speed_m_s}, {0.0}}; }, 200);
  };
  ocean::Environment environment{.currents = stream(0.1)};
  environment.members = {environment.currents, stream(0.0), stream(-0.1)};
  PlanRequest request = arriving_after(120.0);
  request.uncertainty.objective = RobustObjective::quantile;
  request.uncertainty.quantile = 0.99;
  request.uncertainty.arrive_before = request.departures.arrive_by;

  const auto plan = plan_arrival(environment, request, {}, {});

  ASSERT_TRUE(plan.has_value()) << plan.error().explanation();
  const core::UtcTime last = plan->departure + *plan->uncertainty->spread.quantile(0.99);
  EXPECT_NEAR((*request.departures.arrive_by - last).count(), 0.0, 2e-3 * plan->travel_time().count() + 60.0);
}

/// The first member runs against the vehicle, the others with it.
TEST(PlanArrival, SaysWhereTheMeanOfTheMembersIsInTimeAndThePlanItselfIsNot) {
  const auto stream = [](double speed_m_s) {
    return currents_from([=](geo::LonLat, double) { return geo::VelocityEn{{speed_m_s}, {0.0}}; }, 200);
  };
  ocean::Environment sea{.currents = stream(-0.05)};
  sea.members = {sea.currents, stream(0.05), stream(0.05)};
  PlanRequest request = arriving_after(120.0);
  request.uncertainty.objective = RobustObjective::mean;

  const auto plan = plan_arrival(sea, request, {}, {});

  ASSERT_TRUE(plan.has_value()) << plan.error().explanation();
  EXPECT_GT(plan->arrival, *request.departures.arrive_by);
  EXPECT_THAT(messages::sentences(plan->messages),
              testing::Contains(testing::HasSubstr("The mean of all members")));
}

TEST(PlanArrival, SaysWhenTheEarliestDepartureArrives) {
  const PlanRequest request = arriving_after(10.0);

  const auto plan = plan_arrival({}, request, {}, {});

  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().reason, Reason::arrival_too_early);
  EXPECT_NE(plan.error().explanation().find("arrives only at"), std::string::npos)
      << plan.error().explanation();
}

TEST(PlanArrival, SaysWhyThereIsNoWayAtAll) {
  const ocean::Environment environment{.bathymetry = support::bathymetry_from([](geo::LonLat place) {
                                         return std::abs(place.lon_deg + 53.0) < 0.15 ? -1.0 : 300.0;
                                       })};

  const auto plan = plan_arrival(environment, arriving_after(100.0), {}, {});

  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().reason, Reason::goal_unreachable);
}

}  // namespace
}  // namespace floeplan::planning::search::latest_departure_test
