#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_icebergs_test {
namespace {

using support::uniform;

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

TEST(PlanAmongIcebergs, FindsTheOnlyWayThroughWhenItOpensLater) {
  // A berg drifts eastwards through the gap at a third of the vehicle's speed, and closes the whole gap for a while.
  PlanRequest request = support::eastward_request();
  request.icebergs.margin = core::Metres{5500.0};
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment{.bathymetry = wall_with_a_gap()};
  const Result<Plan> free = plan(environment, request);
  environment.icebergs = {drifting_berg({-53.2, 69.0}, 100.0, 0.12, 90.0)};

  const Result<Plan> later = plan(environment, request);

  ASSERT_TRUE(free.has_value());
  ASSERT_TRUE(later.has_value()) << later.error().explanation();
  EXPECT_GT(later->travel_time().count(), free->travel_time().count() + 3.0 * hour_s);
  EXPECT_GT(later->clearances.iceberg->value, request.icebergs.margin.value);
}

class PlanAmongIcebergsOfAScene : public IcebergScenes {};

TEST_P(PlanAmongIcebergsOfAScene, NeverLeadsIntoADiscWhenSimulatedSecondBySecond) {
  int found = 0;
  int detours = 0;
  for_each_scene([&](std::mt19937_64& rng) {
    const auto [request, environment] = random_scene(rng);

    const Result<Plan> result = plan(environment, request);

    if (!result) return;
    ++found;
    detours += result->waypoints.size() > 2 ? 1 : 0;
    EXPECT_GT(least_gap_m(*result, environment, request.icebergs), -tolerance_m);
  });
  EXPECT_GT(found, scenes / 2);
  EXPECT_GT(detours, scenes / 5);
}

INSTANTIATE_TEST_SUITE_P(Quarter, PlanAmongIcebergsOfAScene, testing::Range(0, 4));

/// About 13 km eastwards among bergs in a tide, on a grid of 150 m.
Scene tidal_scene(std::mt19937_64& rng) {
  const double phase = uniform(rng, 0.0, 6.28);
  const double strength_m_s = uniform(rng, 0.05, 0.15);
  const auto tide = [=](geo::LonLat place, double hour) {
    const double turn = 2.0 * std::numbers::pi * hour / 12.42 + phase;
    return geo::VelocityEn{{strength_m_s * std::cos(turn + 20.0 * place.lat_deg)},
                           {strength_m_s * std::sin(turn + 9.0 * place.lon_deg)}};
  };
  Scene scene{.request = support::eastward_request(),
              .environment = {.currents = support::currents_from(tide, 72)}};
  scene.request.from = {-53.16, 69.0};
  scene.request.to = {-52.84, 69.0};
  scene.request.spacing_along = core::Metres{150.0};
  scene.request.refine = false;
  scene.request.optimality_gap = false;
  scene.request.icebergs.margin = core::Metres{uniform(rng, 100.0, 400.0)};
  scene.request.icebergs.max_inflation = core::Metres{0.0};
  for (int i = 0; i < 8; ++i) {
    const geo::LonLat place{uniform(rng, -53.14, -52.86), uniform(rng, 68.98, 69.02)};
    scene.environment.icebergs.push_back(
        drifting_berg(place, uniform(rng, 10.0, 300.0), uniform(rng, 0.0, 0.2), uniform(rng, 0.0, 360.0)));
  }
  return scene;
}

/// Law: open legs are never joined into a leg that is closed.
TEST(PlanAmongIcebergs, ComesOfAnyWayThatTheSearchFinds) {
  int found = 0;
  int refused = 0;
  support::for_each_seed(90, [&](std::mt19937_64& rng) {
    const auto [request, environment] = tidal_scene(rng);
    PlanRequest as_found = request;
    as_found.max_leg = core::Metres{160.0};
    if (!planner::try_to_plan(environment, as_found, {}, {})) return;
    ++found;
    if (!planner::try_to_plan(environment, request, {}, {})) ++refused;
  });
  EXPECT_GT(found, 30);
  EXPECT_EQ(refused, 0);
}

TEST(PlanAmongIcebergs, IsTheOneWithoutThemWhereTheyAreFar) {
  const ocean::Environment empty;
  ocean::Environment far;
  far.icebergs = {drifting_berg({-51.0, 70.0}, 100.0, 0.2, 90.0)};
  const PlanRequest request = support::eastward_request();

  const Result<Plan> with = plan(far, request);
  const Result<Plan> without = plan(empty, request);

  ASSERT_TRUE(with && without);
  EXPECT_EQ(with->arrival, without->arrival);
  EXPECT_EQ(with->search.expansions, without->search.expansions);
  ASSERT_TRUE(with->clearances.iceberg);
  EXPECT_GT(with->clearances.iceberg->value, 50'000.0);
}

TEST(PlanAmongIcebergs, ReportsTheLeastDistanceFromTheHullOverTime) {
  // A standing berg beside the straight route: the clearance is the distance of the line.
  const PlanRequest request = support::eastward_request();
  const geo::LonLat middle = geo::geodesic_destination(
      request.from, geo::geodesic_between(request.from, request.to).course_at_start, core::Metres{20'000.0});
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at(
      geo::geodesic_destination(middle, geo::Bearing::degrees(180.0), core::Metres{15'000.0}), 200.0)};

  const Result<Plan> result = plan(environment, request);

  ASSERT_TRUE(result);
  EXPECT_NEAR(result->clearances.iceberg->value, 14'900.0, 20.0);
  ASSERT_TRUE(result->iceberg_encounters);
  EXPECT_GT(*result->iceberg_encounters, 0.0);
  EXPECT_LT(*result->iceberg_encounters, 0.05);
  double of_legs = 0.0;
  for (const Waypoint& waypoint : result->waypoints) of_legs += waypoint.iceberg_encounters.value_or(0.0);
  EXPECT_NEAR(of_legs, *result->iceberg_encounters, 1e-12);
}

TEST(PlanAmongIcebergs, CannotBeginInsideADiscAndNamesTheBerg) {
  PlanRequest request = support::eastward_request();
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at({-53.47, 69.0}, 100.0)};
  environment.icebergs[0].id = "B-17";
  environment.icebergs[0].observed = start - core::Seconds{4.0 * hour_s};

  const Result<Plan> result = plan(environment, request);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::start_near_iceberg);
  EXPECT_NE(result.error().explanation().find("B-17"), std::string::npos) << result.error().explanation();
  EXPECT_NE(result.error().explanation().find("3.0 km position error"), std::string::npos)
      << result.error().explanation();
}

TEST(PlanAmongIcebergs, SaysWhenADiscThatMovesLeavesTheStart) {
  // A margin of 500 m and 50 m of hull at 0.2 m/s take 46 minutes.
  PlanRequest request = support::eastward_request();
  request.icebergs.max_inflation = core::Metres{0.0};
  request.holds.longest = core::Seconds{12.0 * hour_s};
  ocean::Environment environment;
  environment.icebergs = {drifting_berg(request.from, 100.0, 0.2, 0.0)};

  const Result<Plan> result = plan(environment, request);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::start_near_iceberg);
  const std::string until = core::iso8601(start + core::Seconds{550.0 / 0.2});
  EXPECT_NE(result.error().explanation().find(", until " + until.substr(0, 15)), std::string::npos)
      << result.error().explanation();
}

TEST(PlanAmongIcebergs, MayEndWhereABergIsGoneByThen) {
  // At the departure the goal lies inside the disc. When the vehicle arrives, the berg is far to the north.
  PlanRequest request = support::eastward_request();
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment;
  environment.icebergs = {drifting_berg(request.to, 100.0, 0.3, 0.0)};

  EXPECT_TRUE(plan(environment, request).has_value());

  request.icebergs.drift = false;
  const Result<Plan> standing = plan(environment, request);
  ASSERT_FALSE(standing);
  EXPECT_EQ(standing.error().reason, Reason::goal_near_iceberg);
}

TEST(PlanAmongIcebergs, NamesTheBergInTheWayOfAGivenRoute) {
  const PlanRequest request = support::eastward_request();
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at({-53.0, 69.0}, 100.0)};
  environment.icebergs[0].id = "57";

  const Result<Plan> result = evaluate_route(environment, {request.from, request.to}, request);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::near_iceberg);
  EXPECT_NE(result.error().explanation().find("iceberg 57 at "), std::string::npos)
      << result.error().explanation();
  EXPECT_GT(result.error().when, request.depart);
}

TEST(PlanAmongIcebergs, RefusesMoreIcebergsThanCanBeForecast) {
  ocean::Environment environment;
  environment.icebergs.assign(1'000'000, support::iceberg_at({-53.0, 69.2}, 100.0));

  const Result<Plan> result = plan(environment, support::eastward_request());

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::too_large);
}

TEST(PlanAmongIcebergs, EndsSoonAfterItIsCancelled) {
  // Bergs that drift to and fro everywhere keep the search among later arrivals busy.
  std::mt19937_64 rng{7};
  PlanRequest request = support::eastward_request();
  request.spacing_along = core::Metres{250.0};
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment;
  for (int i = 0; i < 300; ++i) {
    environment.icebergs.push_back(drifting_berg({uniform(rng, -53.4, -52.6), uniform(rng, 68.8, 69.2)},
                                                 100.0, uniform(rng, 0.05, 0.3), uniform(rng, 0.0, 360.0)));
  }
  std::stop_source stop;
  const auto progress = [&](std::string_view stage, double) {
    if (stage == "search") stop.request_stop();
  };

  const Result<Plan> result = plan_route(environment, request, stop.get_token(), progress);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::cancelled);
}

}  // namespace
}  // namespace floeplan::planning::plan_icebergs_test
