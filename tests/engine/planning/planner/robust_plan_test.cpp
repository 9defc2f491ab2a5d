#include "engine/planning/planner/robust_plan.hpp"

#include <gmock/gmock.h>

#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/backwards.hpp"
#include "tests/support/done_elsewhere.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::planner::robust_plan_test {
namespace {

using support::currents_from;
using support::eastward_request;

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

/// A stream along the route, north of it or south of it.
std::shared_ptr<const ocean::CurrentGrid> stream(double middle_lat, double speed_m_s) {
  return currents_from(
      [=](geo::LonLat p, double) {
        const double across = (p.lat_deg - middle_lat) / 0.06;
        return geo::VelocityEn{{speed_m_s * std::exp(-across * across)}, {0.0}};
      },
      120);
}

PlanRequest coarse_request() {
  PlanRequest request = eastward_request();
  request.spacing_along = core::Metres{2000.0};
  return request;
}

ocean::Environment ensemble(std::vector<std::shared_ptr<const ocean::CurrentGrid>> members) {
  ocean::Environment environment{.currents = members.front()};
  environment.members = std::move(members);
  return environment;
}

TEST(RobustPlan, SaysHowTheRouteFaresInEveryMember) {
  const ocean::Environment environment = ensemble({stream(69.0, 0.1), stream(69.0, 0.0), stream(69.0, -0.1)});
  PlanRequest request = coarse_request();
  request.method = Method::direct;

  const auto found = plan(environment, request);

  ASSERT_TRUE(found && found->uncertainty);
  const ArrivalSpread& spread = found->uncertainty->spread;
  EXPECT_EQ(spread.arrived(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto alone = plan({.currents = environment.members[i]}, request);
    ASSERT_TRUE(alone.has_value());
    EXPECT_NEAR(spread.travel_times()[i]->count(), alone->travel_time().count(), 1.0);
  }
  EXPECT_LT(*spread.travel_times()[0], *spread.travel_times()[2]);
}

TEST(RobustPlan, LetsIcebergsDriftWithTheWiderCurrentsOfEachMember) {
  // The second member carries the berg onto the route. In the first it stays where it is.
  ocean::Environment environment = ensemble({stream(69.0, 0.0), stream(69.0, 0.0)});
  environment.drift_members = {
      environment.currents,
      currents_from([](geo::LonLat, double) { return geo::VelocityEn{{0.0}, {0.2}}; }, 120)};
  environment.drift_currents = environment.drift_members.front();
  environment.icebergs = {support::iceberg_at({-53.0, 68.9}, 300.0)};
  PlanRequest request = coarse_request();
  request.method = Method::direct;
  request.holds.longest = core::Seconds{0.0};
  request.icebergs.max_inflation = core::Metres{500.0};

  const auto found = plan(environment, request);

  ASSERT_TRUE(found && found->uncertainty);
  EXPECT_EQ(found->uncertainty->spread.arrived(), 1U);
}

TEST(RobustPlan, TakesTheRouteThatIsBestOnAverageAndNotThatOfTheFirstMember) {
  // The first member has a helpful stream in the north; in the others the same place runs against the vehicle.
  const ocean::Environment environment =
      ensemble({stream(69.1, 0.25), stream(69.1, -0.3), stream(69.1, -0.3), stream(69.1, -0.3)});
  PlanRequest request = coarse_request();
  const auto trusting = plan(environment, request);
  request.uncertainty.objective = RobustObjective::mean;

  const auto robust = plan(environment, request);

  ASSERT_TRUE(trusting && robust);
  EXPECT_LT(*robust->uncertainty->spread.mean(), *trusting->uncertainty->spread.mean());
  EXPECT_GE(robust->travel_time(), trusting->travel_time())
      << "in the first member nothing beats its own route";
  EXPECT_GT(robust->uncertainty->candidates, 1U);
}

TEST(RobustPlan, IsNeverWorseInItsObjectiveThanThePlanOfTheFirstMember) {
  PlanRequest request = coarse_request();
  const ocean::Environment environment{.currents = stream(69.05, 0.15)};
  request.uncertainty.drawn_members = 6;
  request.uncertainty.error = {{0.08}, {20'000.0}, core::Seconds{43'200.0}};
  request.uncertainty.arrive_before = request.depart + core::Seconds{36.0 * 3600.0};
  const auto trusting = plan(environment, request);
  request.uncertainty.objective = RobustObjective::quantile;
  request.uncertainty.quantile = 0.8;

  const auto robust = plan(environment, request);
  const auto again = plan(environment, request);

  ASSERT_TRUE(trusting && robust && again);
  EXPECT_LE(*robust->uncertainty->spread.quantile(0.8), *trusting->uncertainty->spread.quantile(0.8));
  EXPECT_GT(robust->uncertainty->spread.standard_deviation()->count(), 100.0);
  EXPECT_EQ(robust->arrival, again->arrival) << "the same seed, the same plan";
  EXPECT_DOUBLE_EQ(*robust->uncertainty->chance,
                   robust->uncertainty->spread.chance_within(core::Seconds{36.0 * 3600.0}));
}

TEST(RobustPlan, IsTheSameToTheLastBitOnHoweverManyThreads) {
  const ocean::Environment environment =
      ensemble({stream(68.95, 0.15), stream(69.0, 0.1), stream(69.05, 0.15), stream(69.0, -0.1)});
  PlanRequest request = coarse_request();
  request.uncertainty.objective = RobustObjective::mean;
  const auto in_order = plan(environment, request);

  const auto at_once = plan_route(environment, request, {}, {}, {}, support::Backwards{});

  ASSERT_TRUE(in_order && at_once);
  EXPECT_EQ(at_once->arrival, in_order->arrival);
  EXPECT_EQ(at_once->uncertainty->candidates, in_order->uncertainty->candidates);
  EXPECT_EQ(at_once->uncertainty->spread.travel_times(), in_order->uncertainty->spread.travel_times());
}

TEST(RobustPlan, FindsTheWayBetweenThoseThatTheMembersTake) {
  // Each member has a strong helpful current on one side and an adverse one on the other. The middle is never bad.
  const auto either = [](double side) {
    return currents_from(
        [=](geo::LonLat p, double) {
          const double north = std::clamp((p.lat_deg - 69.0) / 0.1, -1.0, 1.0);
          return geo::VelocityEn{{side * 0.3 * north}, {0.0}};
        },
        160);
  };
  const ocean::Environment environment = ensemble({either(1.0), either(-1.0)});
  PlanRequest request = coarse_request();
  const auto trusting = plan(environment, request);
  request.uncertainty.objective = RobustObjective::quantile;
  request.uncertainty.quantile = 0.99;

  const auto robust = plan(environment, request);

  ASSERT_TRUE(trusting && robust);
  EXPECT_LT(*robust->uncertainty->spread.quantile(0.99), 0.8 * *trusting->uncertainty->spread.quantile(0.99));
  for (const Waypoint& waypoint : robust->waypoints) EXPECT_NEAR(waypoint.place.lat_deg, 69.0, 0.02);
}

TEST(RobustPlan, CountsAMemberThatDoesNotLetTheRouteThrough) {
  const ocean::Environment environment = ensemble({stream(69.0, 0.0), stream(69.0, -0.8)});
  PlanRequest request = coarse_request();
  request.method = Method::direct;

  const auto found = plan(environment, request);

  ASSERT_TRUE(found && found->uncertainty);
  EXPECT_EQ(found->uncertainty->spread.arrived(), 1U);
  EXPECT_FALSE(found->uncertainty->spread.travel_times()[1].has_value());
}

TEST(RobustPlan, SaysThatAShareCannotBeMetAndTakesTheBestInTheMeanOfTheOthers) {
  const auto against = currents_from([](geo::LonLat, double) { return geo::VelocityEn{{-0.5}, {0.0}}; }, 120);
  const ocean::Environment environment =
      ensemble({stream(69.1, 0.25), stream(69.1, -0.3), stream(69.1, -0.3), against});
  PlanRequest request = coarse_request();
  request.uncertainty.objective = RobustObjective::mean;
  const auto by_mean = plan(environment, request);
  request.uncertainty.objective = RobustObjective::quantile;
  request.uncertainty.quantile = 0.9;

  const auto found = plan(environment, request);

  ASSERT_TRUE(found && by_mean);
  EXPECT_EQ(found->uncertainty->spread.quantile(0.9), std::nullopt);
  EXPECT_THAT(
      messages::sentences(found->messages),
      testing::Contains(testing::AllOf(testing::HasSubstr("in 1 of 4 members"),
                                       testing::HasSubstr("asks for arrival in 90 % of the members"))));
  EXPECT_EQ(*found->uncertainty->spread.mean(), *by_mean->uncertainty->spread.mean());
}

TEST(RobustPlan, LetsEveryMemberThroughTheGapsOfTheLandThatThePlanPasses) {
  support::for_each_seed(12, [](std::mt19937_64& rng) {
    ocean::Environment environment = ensemble({stream(69.0, 0.05), stream(69.0, 0.05)});
    const double south = 69.0 + support::uniform(rng, -0.1, 0.1);
    const double north = south + support::uniform(rng, 0.012, 0.03);
    const auto wall = [](double from, double to) {
      return geo::Polygon{.outer = {{-53.02, from}, {-52.98, from}, {-52.98, to}, {-53.02, to}}, .holes = {}};
    };
    environment.land = {wall(68.6, south), wall(north, 69.4)};

    const auto found = plan(environment, coarse_request());

    ASSERT_TRUE(found && found->uncertainty) << south << " to " << north;
    const ArrivalSpread& spread = found->uncertainty->spread;
    ASSERT_EQ(spread.arrived(), 2U) << south << " to " << north;
    for (const auto& time : spread.travel_times())
      EXPECT_NEAR(time->count(), found->travel_time().count(), 0.01);
  });
}

TEST(RobustPlan, SaysHowThePlanFaresWhateverItsObjective) {
  ocean::Environment environment = ensemble({stream(69.0, -0.2), stream(69.0, 0.0), stream(69.05, 0.15)});
  environment.icebergs = {support::iceberg_at({-53.0, 69.12}, 200.0)};
  PlanRequest request = coarse_request();
  std::vector<PlanRequest> requests(4, request);
  requests[0].energy.objective = energy_objective;
  requests[1].energy.objective = {1.0, 0.01};
  requests[2].energy.objective = {1.0, 0.001};
  requests[2].vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  requests[3].icebergs.encounter_weight = core::Seconds{36'000.0};

  for (PlanRequest& each : requests) {
    for (const RobustObjective objective : {RobustObjective::none, RobustObjective::mean}) {
      each.uncertainty.objective = objective;

      const auto found = plan(environment, each);

      ASSERT_TRUE(found && found->uncertainty);
      EXPECT_EQ(found->uncertainty->spread.arrived(), 3U);
      EXPECT_NEAR(found->uncertainty->spread.travel_times()[0]->count(), found->travel_time().count(), 1.0)
          << "the first member has the currents that the plan is timed in";
      EXPECT_FALSE(found->optimality_gap.has_value());
      EXPECT_EQ(found->optimality_gap_reason, "the currents are uncertain, so no single route is the best");
    }
  }
}

TEST(RobustPlan, OfEnergyTakesTheRouteThatDrawsLeastOnAverage) {
  // As above: where power is the same everywhere, the least energy is the least time.
  const ocean::Environment environment =
      ensemble({stream(69.1, 0.25), stream(69.1, -0.3), stream(69.1, -0.3), stream(69.1, -0.3)});
  PlanRequest request = coarse_request();
  request.energy.objective = energy_objective;
  const auto trusting = plan(environment, request);
  request.uncertainty.objective = RobustObjective::mean;

  const auto robust = plan(environment, request);

  ASSERT_TRUE(trusting && robust);
  EXPECT_LT(*robust->uncertainty->spread.mean(), *trusting->uncertainty->spread.mean());
}

TEST(RobustPlan, NamesEveryFaultOfItsRules) {
  PlanRequest request = eastward_request();
  request.uncertainty.drawn_members = 1;
  request.uncertainty.quantile = 1.0;

  EXPECT_EQ(request.violations().size(), 5U) << "members, quantile and the three numbers of the error model";
}

TEST(RobustPlan, IsTheSameWhenTheMembersWerePlannedElsewhere) {
  const ocean::Environment environment =
      ensemble({stream(69.0, -0.1), stream(69.05, 0.15), stream(68.95, 0.1)});
  PlanRequest request = coarse_request();
  request.uncertainty.objective = RobustObjective::mean;
  support::KeptParts kept;
  const auto here = plan_route(environment, request, {}, {}, {}, support::KeepsParts{kept});

  const auto elsewhere = plan_route(environment, request, {}, {}, {}, support::DoneElsewhere{kept});

  ASSERT_TRUE(here && elsewhere);
  EXPECT_EQ(kept.size(), 4U) << "three members, and their mean";
  EXPECT_EQ(elsewhere->arrival, here->arrival);
  ASSERT_EQ(elsewhere->waypoints.size(), here->waypoints.size());
  for (std::size_t i = 0; i < here->waypoints.size(); ++i)
    EXPECT_EQ(elsewhere->waypoints[i].place, here->waypoints[i].place) << i;
}

}  // namespace
}  // namespace floeplan::planning::planner::robust_plan_test
