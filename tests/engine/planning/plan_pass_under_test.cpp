#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/messages/sentence.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/obstacles/pass_under.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_pass_under_test {
namespace {

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return planner::try_to_plan(environment, request, {}, {});
}

/// A berg of a stated draft in the only gap of a wall.
Scene plugged_gap(double draft_m) {
  PlanRequest request = support::eastward_request();
  request.icebergs.margin = core::Metres{5500.0};
  request.icebergs.drift = false;
  request.icebergs.pass_under = true;
  ocean::Environment environment{.bathymetry = wall_with_a_gap()};
  environment.icebergs = {support::iceberg_at({-53.0, 69.0}, 60.0)};
  environment.icebergs[0].id = "B-17";
  environment.icebergs[0].draft = core::Metres{draft_m};
  return {request, environment};
}

TEST(PassUnder, IsNeverDoneUnasked) {
  auto [request, environment] = plugged_gap(40.0);
  request.icebergs.pass_under = false;

  EXPECT_FALSE(plan(environment, request));
  EXPECT_FALSE(PlanRequest{}.icebergs.pass_under);
}

TEST(PassUnder, LeadsBelowTheKeelAndSaysSo) {
  auto [request, environment] = plugged_gap(40.0);

  const Result<Plan> result = plan(environment, request);

  ASSERT_TRUE(result) << result.error().explanation();
  ASSERT_EQ(result->passed_under.size(), 1U);
  const PassedUnder& under = result->passed_under[0];
  EXPECT_EQ(under.iceberg, "B-17");
  EXPECT_TRUE(under.keel.draft_is_stated);
  EXPECT_NEAR(under.keel.deepest.value, 50.0, 1e-9);
  EXPECT_NEAR(under.keel.upper_turn.value, 70.0, 1e-9);
  // Eleven kilometres of the disc at 0.35 m/s.
  EXPECT_NEAR((under.until - under.from).count(), 2.0 * 5530.0 / 0.35, 700.0);
  EXPECT_TRUE(std::ranges::any_of(messages::sentences(result->messages), [](const std::string& warning) {
    return warning.find("under iceberg B-17 from") != std::string::npos;
  }));
}

TEST(PassUnder, LeavesRoomForADiveBelowTheKeelWhateverTheMargins) {
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const plane::PlaneBox area{{-20'000.0, -20'000.0}, {20'000.0, 20'000.0}};
  int open = 0;
  support::for_each_seed(200, [&](std::mt19937_64& rng) {
    const double bed_m = support::uniform(rng, 20.0, 250.0);
    const ocean::Environment environment{.bathymetry =
                                             support::bathymetry_from([=](geo::LonLat) { return bed_m; })};
    IcebergRules rules;
    rules.pass_under = true;
    vehicle::GliderProfile vehicle = support::eastward_request().vehicle;
    vehicle.minimum_working_depth = core::Metres{support::uniform(rng, 0.0, 40.0)};
    vehicle.altimeter_margin = core::Metres{support::uniform(rng, 0.0, 60.0)};
    vehicle.dive_depth = core::Metres{support::uniform(rng, 30.0, 200.0)};
    ocean::Iceberg berg = support::iceberg_at({-53.0, 69.0}, 60.0);
    berg.draft = core::Metres{support::uniform(rng, 1.0, 100.0)};
    const obstacles::PassUnder under{
        rules, vehicle,
        obstacles::lay_out_bed(environment.bathymetry, vehicle, projection, area, core::Metres{500.0}, {})};

    const auto keel = under.keel_of(berg);
    if (!keel || !under.has_room({0.0, 0.0}, keel->upper_turn)) return;

    ++open;
    const double bottom_m = std::min(vehicle.dive_depth.value, bed_m - vehicle.altimeter_margin.value);
    EXPECT_GE(bottom_m - keel->upper_turn.value, vehicle::lowest_tooth.value - 1e-3);
  });
  EXPECT_GT(open, 20);
}

TEST(PassUnder, ForbidsSurfacingInTheDisc) {
  auto [request, environment] = plugged_gap(40.0);
  request.max_leg = core::Metres{2000.0};

  const Result<Plan> result = plan(environment, request);

  ASSERT_TRUE(result && result->surfacing);
  const PassedUnder& under = result->passed_under.at(0);
  int below = 0;
  for (std::size_t i = 0; i < result->waypoints.size(); ++i) {
    const core::UtcTime eta = result->waypoints[i].eta;
    const bool inside = under.from < eta && eta < under.until;
    EXPECT_EQ(result->surfacing->waypoints[i].may_surface, !inside) << i;
    EXPECT_EQ(result->surfacing->waypoints[i].least_upper_turn.value,
              inside ? under.keel.upper_turn.value : 0.0);
    below += inside ? 1 : 0;
  }
  EXPECT_GE(below, 4);
  EXPECT_NEAR(result->surfacing->longest_without.count(), (under.until - under.from).count(), 1500.0);
}

TEST(PassUnder, IsNotPossibleBelowAKeelThatTheDivesDoNotReach) {
  // Dives to 200 m; 1.25 times 140 m and the clearance of 20 m leave no room.
  auto [request, environment] = plugged_gap(140.0);
  EXPECT_FALSE(plan(environment, request));

  request.icebergs.draft_uncertainty = 0.0;
  EXPECT_TRUE(plan(environment, request));
}

TEST(PassUnder, IsNotPossibleWhereTheSeaIsTooShallow) {
  auto [request, environment] = plugged_gap(40.0);
  // The keel may reach 50 m, dives turn at 70 m and need 20 m from there to the bed.
  const auto deep_as = [](double depth_m) {
    return support::bathymetry_from([depth_m](geo::LonLat p) {
      if (std::abs(p.lon_deg + 53.0) >= 0.15) return 300.0;
      return std::abs(p.lat_deg - 69.0) < 0.026 ? depth_m : 5.0;
    });
  };
  environment.bathymetry = deep_as(85.0);
  EXPECT_FALSE(plan(environment, request));

  environment.bathymetry = deep_as(130.0);  // and 90 m still for 1.8 km to either side
  EXPECT_TRUE(plan(environment, request));
}

TEST(PassUnder, IsRefusedForABergOfUnknownSize) {
  auto [request, environment] = plugged_gap(40.0);
  environment.icebergs[0].draft.reset();
  environment.icebergs[0].length.reset();
  environment.icebergs[0].size = ocean::IcebergSize::radar_target;
  request.icebergs.draft_uncertainty = 0.0;
  request.vehicle = *vehicle::find_profile("slocum-g3-1000");
  EXPECT_FALSE(plan(environment, request));

  environment.icebergs[0].size = ocean::IcebergSize::small;
  const Result<Plan> known = plan(environment, request);
  ASSERT_TRUE(known);
  EXPECT_FALSE(known->passed_under.at(0).keel.draft_is_stated);
}

TEST(PassUnder, DoesNotBeginOrEndUnderABerg) {
  PlanRequest request = support::eastward_request();
  request.icebergs.drift = false;
  request.icebergs.pass_under = true;
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at(request.from, 60.0)};
  const Result<Plan> at_start = plan(environment, request);
  ASSERT_FALSE(at_start);
  EXPECT_EQ(at_start.error().reason, Reason::start_near_iceberg);

  environment.icebergs = {support::iceberg_at(request.to, 60.0)};
  const Result<Plan> at_goal = plan(environment, request);
  ASSERT_FALSE(at_goal);
  EXPECT_EQ(at_goal.error().reason, Reason::goal_near_iceberg);
}

TEST(PassUnder, LeadsARouteThatTurnsBelowTheBerg) {
  auto [request, environment] = plugged_gap(40.0);

  const Result<Plan> result = evaluate_route(environment, {request.from, {-53.0, 69.0}, request.to}, request);

  ASSERT_TRUE(result) << result.error().explanation();
  EXPECT_EQ(result->passed_under.size(), 1U);
}

TEST(PassUnder, CountsAsTimeWithoutASurfacingWhereThatIsBounded) {
  // Below the disc for nine hours, under no ice or in water that is open but for the berg.
  for (const bool ice_is_known : {false, true}) {
    auto [request, environment] = plugged_gap(40.0);
    if (ice_is_known)
      environment.ice = support::ice_from([](geo::LonLat, double) { return 0.0; }, {0.0}, 1.0);
    request.under_ice.max_time_without_surfacing = core::Seconds{12.0 * 3600.0};
    const Result<Plan> allowed = plan(environment, request);
    ASSERT_TRUE(allowed) << allowed.error().explanation();
    EXPECT_EQ(allowed->passed_under.size(), 1U);
    EXPECT_LE(allowed->surfacing->longest_without, *request.under_ice.max_time_without_surfacing);

    request.under_ice.max_time_without_surfacing = core::Seconds{6.0 * 3600.0};
    const Result<Plan> refused = plan(environment, request);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().reason, Reason::no_surfacing);
  }
}

class PassUnderInAScene : public IcebergScenes {};

TEST_P(PassUnderInAScene, NeverLeadsIntoADiscButBelowAKeelAndArrivesNoLater) {
  int found = 0;
  int under = 0;
  for_each_scene([&](std::mt19937_64& rng) {
    auto [request, environment] = random_scene(rng);
    for (ocean::Iceberg& berg : environment.icebergs)
      berg.draft = core::Metres{support::uniform(rng, 5.0, 250.0)};
    const Result<Plan> round = plan(environment, request);
    request.icebergs.pass_under = true;

    const Result<Plan> result = plan(environment, request);

    if (!result) {
      EXPECT_FALSE(round) << "passing under is allowed, not asked for";
      return;
    }
    ++found;
    under += result->passed_under.empty() ? 0 : 1;
    EXPECT_GT(least_gap_m(*result, environment, request.icebergs), -tolerance_m);
    for (const PassedUnder& passed : result->passed_under) {
      const auto berg = std::ranges::find(environment.icebergs, passed.iceberg, &ocean::Iceberg::id);
      ASSERT_NE(berg, environment.icebergs.end());
      EXPECT_GE(passed.keel.upper_turn.value, 1.25 * berg->draft->value + 20.0 - 1e-9);
      EXPECT_LE(passed.keel.upper_turn.value + 10.0, request.vehicle.dive_depth.value);
    }
    if (round) {
      EXPECT_LE(result->travel_time().count(), round->travel_time().count());
    }
  });
  EXPECT_GT(found, scenes / 2);
  EXPECT_GT(under, scenes / 15);
}

INSTANTIATE_TEST_SUITE_P(Quarter, PassUnderInAScene, testing::Range(0, 4));

}  // namespace
}  // namespace floeplan::planning::plan_pass_under_test
