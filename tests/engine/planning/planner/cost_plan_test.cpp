#include <gtest/gtest.h>

#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::planner::cost_plan_test {
namespace {

using support::bathymetry_from;
using support::currents_from;
using support::eastward_request;

Result<Plan> plan(const ocean::Environment& environment, PlanRequest request, const Objective& objective) {
  request.energy.objective = objective;
  request.optimality_gap = false;
  return plan_route(environment, request, {}, {});
}

PlanRequest hybrid_request() {
  PlanRequest request = eastward_request();
  request.spacing_along = core::Metres{2000.0};
  request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  return request;
}

geo::VelocityEn tide(geo::LonLat place, double hour) {
  const double phase = 2.0 * 3.14159265358979 * hour / 12.42;
  return {{0.15 * std::cos(phase)}, {0.2 * std::sin(phase + place.lon_deg)}};
}

/// Shallow along the straight route, deep to the north of it.
std::shared_ptr<const ocean::Bathymetry> bank() {
  return bathymetry_from([](geo::LonLat place) {
    const bool on_bank = std::abs(place.lat_deg - 69.0) < 0.06 && std::abs(place.lon_deg + 53.0) < 0.3;
    return on_bank ? 25.0 : 400.0;
  });
}

double energy_j(const Plan& plan) { return plan.energy->use.total().value; }

TEST(CostPlan, IsTheFastestPlanWhereOneDriveDrawsTheSamePowerEverywhere) {
  const ocean::Environment environment{.currents = currents_from(tide, 96)};

  const auto fastest = plan(environment, eastward_request(), time_objective);
  const auto cheapest = plan(environment, eastward_request(), energy_objective);

  ASSERT_TRUE(fastest && cheapest);
  EXPECT_NEAR(cheapest->travel_time().count(), fastest->travel_time().count(), 0.1);
  EXPECT_NEAR(energy_j(*cheapest), energy_j(*fastest), 1e-5 * energy_j(*fastest));
}

TEST(CostPlan, GoesRoundABankToSaveThePump) {
  const ocean::Environment environment{.bathymetry = bank()};

  const auto fastest = plan(environment, eastward_request(), time_objective);
  const auto cheapest = plan(environment, eastward_request(), energy_objective);

  ASSERT_TRUE(fastest && cheapest);
  EXPECT_LT(energy_j(*cheapest), 0.9 * energy_j(*fastest));
  EXPECT_GT(cheapest->travel_time(), fastest->travel_time());
}

TEST(CostPlan, UsesTheThrusterOnlyAsFarAsItsWeightIsWorthIt) {
  const auto fastest = plan({}, hybrid_request(), time_objective);
  const auto cheapest = plan({}, hybrid_request(), energy_objective);

  ASSERT_TRUE(fastest && cheapest);
  EXPECT_EQ(fastest->waypoints.back().drive, vehicle::Drive::thruster);
  EXPECT_EQ(cheapest->waypoints.back().drive, vehicle::Drive::buoyancy);
  EXPECT_LT(energy_j(*cheapest), energy_j(*fastest));
}

TEST(CostPlan, SavesEnergyAndTheFastestPlanTimeInWhateverCurrents) {
  support::for_each_seed(4, [](std::mt19937_64& rng) {
    const double strength = support::uniform(rng, 0.05, 0.3);
    const double phase = support::uniform(rng, 0.0, 6.28);
    const auto swirl = [&](geo::LonLat place, double hour) {
      const double angle = phase + 4.0 * place.lon_deg + 6.0 * place.lat_deg + 0.3 * hour;
      return geo::VelocityEn{{strength * std::cos(angle)}, {strength * std::sin(angle)}};
    };
    const ocean::Environment environment{.currents = currents_from(swirl, 200), .bathymetry = bank()};
    PlanRequest request = hybrid_request();
    request.spacing_along = core::Metres{4000.0};

    const auto fastest = plan(environment, request, time_objective);
    const auto cheapest = plan(environment, request, energy_objective);

    ASSERT_TRUE(fastest && cheapest);
    EXPECT_LE(energy_j(*cheapest), energy_j(*fastest));
    EXPECT_LE(fastest->travel_time().count(), cheapest->travel_time().count() + 1e-6);
  });
}

TEST(CostPlan, UsesTheThrusterOnlyBelowTheIceThatIsTooWideForTheBuoyancyDrive) {
  // 21 km of ice over the whole sea: 59,000 s on the buoyancy drive.
  ocean::Environment environment;
  environment.ice = support::ice_from(
      [](geo::LonLat place, double) { return std::abs(place.lon_deg + 53.0) < 0.26 ? 0.9 : 0.0; }, {0.0},
      1.0);
  PlanRequest request = hybrid_request();
  request.spacing_along = core::Metres{1000.0};
  request.refine = false;
  request.under_ice.max_time_without_surfacing = core::Seconds{47'000.0};

  for (const std::vector<geo::LonLat>& via : {std::vector<geo::LonLat>{}, {{-53.0, 69.0}}}) {
    request.via = via;  // half way, from where the buoyancy drive alone comes to no opening in time
    const auto fastest = plan(environment, request, time_objective);
    const auto cheapest = plan(environment, request, energy_objective);

    ASSERT_TRUE(fastest && cheapest);
    EXPECT_LT(energy_j(*cheapest), 0.8 * energy_j(*fastest));
    EXPECT_EQ(cheapest->waypoints[1].drive, vehicle::Drive::buoyancy);
    EXPECT_EQ(cheapest->waypoints.back().drive, vehicle::Drive::buoyancy);
    EXPECT_LE(cheapest->surfacing->longest_without, *request.under_ice.max_time_without_surfacing);
  }
}

TEST(CostPlan, TurnsTheThrusterOnWhereTheBuoyancyDriveHardlyMakesWay) {
  // Across the route runs a stream 8 km wide, against the vehicle, at nearly its buoyancy speed of 0.35 m/s.
  const auto stream = [](geo::LonLat place, double) {
    return geo::VelocityEn{{std::abs(place.lon_deg + 53.0) < 0.15 ? -0.32 : 0.0}, {0.0}};
  };
  const ocean::Environment environment{.currents = currents_from(stream, 400)};

  const auto fastest = plan(environment, hybrid_request(), time_objective);
  const auto cheapest = plan(environment, hybrid_request(), energy_objective);

  ASSERT_TRUE(fastest && cheapest);
  std::vector<vehicle::Drive> stretches;
  for (std::size_t i = 1; i < cheapest->waypoints.size(); ++i) {
    const vehicle::Drive drive = cheapest->waypoints[i].drive.value();
    if (stretches.empty() || stretches.back() != drive) stretches.push_back(drive);
  }
  using enum vehicle::Drive;
  EXPECT_EQ(stretches, (std::vector{buoyancy, thruster, buoyancy}));
  EXPECT_LT(energy_j(*cheapest), 0.9 * energy_j(*fastest));
  EXPECT_GT(cheapest->travel_time(), 1.1 * fastest->travel_time());
}

TEST(CostPlan, IsJudgedAsARouteOnTheDrivesThatItWasPlannedWith) {
  const auto stream = [](geo::LonLat place, double) {
    return geo::VelocityEn{{std::abs(place.lon_deg + 53.0) < 0.15 ? -0.4 : 0.0}, {0.0}};
  };
  const ocean::Environment environment{.currents = currents_from(stream, 400)};
  PlanRequest request = hybrid_request();
  request.energy.objective = energy_objective;
  const auto planned = plan(environment, request, energy_objective);
  ASSERT_TRUE(planned.has_value());
  std::vector<geo::LonLat> route;
  for (const Waypoint& waypoint : planned->waypoints) route.push_back(waypoint.place);

  const auto judged = evaluate_route(environment, route, request);

  ASSERT_TRUE(judged.has_value()) << judged.error().explanation();
  EXPECT_NEAR(judged->travel_time().count(), planned->travel_time().count(), 1.0);
  EXPECT_NEAR(energy_j(*judged), energy_j(*planned), 1e-4 * energy_j(*planned));
  for (std::size_t i = 1; i < route.size(); ++i)
    EXPECT_EQ(judged->waypoints[i].drive, planned->waypoints[i].drive);
}

TEST(CostPlan, OfWeightsLiesBetweenTheFastestAndTheMostSaving) {
  const ocean::Environment environment{.currents = currents_from(tide, 200), .bathymetry = bank()};
  const auto fastest = plan(environment, hybrid_request(), time_objective);
  const auto cheapest = plan(environment, hybrid_request(), energy_objective);
  ASSERT_TRUE(fastest && cheapest);
  EXPECT_LE(energy_j(*cheapest), energy_j(*fastest));

  for (const double joule_worth_s : {0.05, 0.3}) {
    const Objective objective{1.0, joule_worth_s};
    const auto between = plan(environment, hybrid_request(), objective);

    ASSERT_TRUE(between.has_value());
    const auto cost = [&](const Plan& p) { return objective.cost(p.travel_time(), p.energy->use.total()); };
    EXPECT_LE(cost(*between), cost(*fastest));
    EXPECT_LE(cost(*between), 1.02 * cost(*cheapest));
    EXPECT_GE(between->travel_time(), 0.99 * fastest->travel_time());
    EXPECT_GE(energy_j(*between), 0.99 * energy_j(*cheapest));
  }
}

TEST(CostPlan, CostsLessWhenItsPointsAreMovedOffTheGrid) {
  const ocean::Environment environment{.currents = currents_from(tide, 200), .bathymetry = bank()};
  PlanRequest request = hybrid_request();
  const auto refined = plan(environment, request, energy_objective);
  request.refine = false;

  const auto plain = plan(environment, request, energy_objective);

  ASSERT_TRUE(refined && plain);
  EXPECT_LT(energy_j(*refined), 0.99 * energy_j(*plain));
  ASSERT_TRUE(refined->refinement && refined->refinement->energy_before && refined->refinement->energy_after);
  EXPECT_LT(*refined->refinement->energy_after, *refined->refinement->energy_before);
  EXPECT_NEAR(refined->refinement->energy_after->value, energy_j(*refined), 1e-6);
  EXPECT_FALSE(plain->refinement.has_value());
}

TEST(CostPlan, KeepsToTheWaypointsAndLegsAskedFor) {
  const ocean::Environment environment{.bathymetry = bank()};
  PlanRequest request = eastward_request();
  request.max_waypoints = 4;
  const auto few = plan(environment, request, energy_objective);
  request.max_waypoints.reset();
  request.max_leg = core::Metres{5000.0};
  const auto parted = plan(environment, request, energy_objective);

  ASSERT_TRUE(few && parted);
  EXPECT_LE(few->waypoints.size(), 4U);
  for (std::size_t i = 1; i < parted->waypoints.size(); ++i) {
    EXPECT_LE(parted->waypoints[i].leg_length->value, 5000.0 * 1.001);
    EXPECT_TRUE(parted->waypoints[i].drive.has_value());
  }
}

TEST(CostPlan, StopsWhenItIsCancelled) {
  std::stop_source source;
  source.request_stop();
  PlanRequest request = hybrid_request();
  request.energy.objective = energy_objective;

  const auto found = plan_route({.bathymetry = bank()}, request, source.get_token(), {});

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::cancelled);
}

}  // namespace
}  // namespace floeplan::planning::planner::cost_plan_test
