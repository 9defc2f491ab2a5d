#include <gtest/gtest.h>

#include <algorithm>

#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_holds_test {
namespace {

constexpr core::Seconds half_a_day{12.0 * hour_s};
/// The vehicle holds instead of taking a detour, if the search finds the hold no worse.
constexpr double just_as_good = 1.002;

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

core::Seconds waited(const Plan& plan) {
  core::Seconds sum{0.0};
  for (const Waypoint& waypoint : plan.waypoints) sum += waypoint.wait;
  return sum;
}

PlanRequest without_holds(PlanRequest request) {
  request.holds.longest = core::Seconds{0.0};
  return request;
}

/// A berg drifts eastwards through the only gap in a wall, and closes the whole gap for a while.
Scene closed_gap() {
  PlanRequest request = support::eastward_request();
  request.icebergs.margin = core::Metres{5500.0};
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment{.bathymetry = wall_with_a_gap()};
  environment.icebergs = {drifting_berg({-53.2, 69.0}, 100.0, 0.12, 90.0)};
  return {request, environment};
}

ocean::Zone closed_at_first(double until_h) {
  return {.name = "trawlers",
          .kind = ocean::ZoneKind::no_go,
          .area = {.outer = {{-53.05, 67.6}, {-52.95, 67.6}, {-52.95, 70.4}, {-53.05, 70.4}}, .holes = {}},
          .from = std::nullopt,
          .until = start + core::Seconds{until_h * hour_s}};
}

/// The current is too strong for three minutes at the full hour: samples at regular times could miss that.
TEST(Holds, EndsBeforeACurrentThatIsTooStrongForMinutesOnly) {
  const auto currents = [](geo::LonLat, double hour) {
    return geo::VelocityEn{{hour == 5.0 ? 0.36 : 0.0}, {0.0}};
  };
  const ocean::Environment environment{.currents = support::currents_from(currents, 48)};
  const PlanRequest request = support::eastward_request();
  const geo::LocalProjection projection{request.from};
  const cost::Sea sea{
      environment, request, projection, {{-20'000.0, -20'000.0}, {20'000.0, 20'000.0}}, core::Metres{1000.0}};

  const core::Seconds held = cost::can_stay_until(sea, {}, core::Seconds{450.0}, core::Seconds{8.0 * hour_s});

  EXPECT_LT(held.count(), 5.0 * hour_s);
  EXPECT_GT(held.count(), 4.5 * hour_s);
}

TEST(Holds, LetTheVehicleThroughAGapThatOpensLater) {
  const auto [request, environment] = closed_gap();
  const Result<Plan> moving = plan(environment, without_holds(request));

  const Result<Plan> holding = plan(environment, request);

  ASSERT_TRUE(holding) << holding.error().explanation();
  EXPECT_GT(waited(*holding).count(), hour_s);
  if (moving) {
    EXPECT_LE(holding->travel_time().count(), just_as_good * moving->travel_time().count());
  }
  EXPECT_GT(holding->clearances.iceberg->value, request.icebergs.margin.value);
}

TEST(Holds, AreAtTheStartWhereDepartingLaterLosesNothing) {
  PlanRequest request = support::eastward_request();
  request.zones = {closed_at_first(60.0)};
  request.zones[0].area.outer = {{-52.6, 68.9}, {-52.3, 68.9}, {-52.3, 69.1}, {-52.6, 69.1}};

  const Result<Plan> result = plan({}, request);

  ASSERT_TRUE(result) << result.error().explanation();
  EXPECT_NEAR(result->waypoints.front().wait.count(), waited(*result).count(), 600.0);
  EXPECT_GT(waited(*result).count(), 10.0 * hour_s);
}

TEST(Holds, IsNotWorthwhileWhereGoingRoundIsFaster) {
  // A berg comes slowly along the straight line. To wait for it would take a day; a small detour leads round it.
  PlanRequest request = support::eastward_request();
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment;
  environment.icebergs = {drifting_berg({-53.0, 69.005}, 200.0, 0.02, 270.0)};
  const Result<Plan> moving = plan(environment, without_holds(request));

  const Result<Plan> waiting = plan(environment, request);

  ASSERT_TRUE(moving && waiting);
  EXPECT_EQ(waited(*waiting).count(), 0.0);
  EXPECT_NEAR(waiting->travel_time().count(), moving->travel_time().count(),
              1e-3 * moving->travel_time().count());
}

class HoldsInAScene : public IcebergScenes {};

TEST_P(HoldsInAScene, NeverArrivesLaterOnAGrid) {
  for_each_scene([&](std::mt19937_64& rng) {
    auto [request, environment] = random_scene(rng);
    request.refine = false;
    const Result<Plan> moving = plan(environment, without_holds(request));
    request.holds.longest = core::Seconds{support::uniform(rng, 0.5, 12.0) * hour_s};

    const Result<Plan> result = plan(environment, request);

    if (!moving) return;
    ASSERT_TRUE(result) << "waiting is allowed, not asked for";
    EXPECT_LE(result->travel_time().count(), just_as_good * moving->travel_time().count());
  });
}

/// Where two routes differ by less than the error of the grid, refinement gets the one that the search prefers. For a vehicle
/// that may not hold, that may be the other one.
TEST_P(HoldsInAScene, NeverLeadsIntoADiscAndHardlyEverArrivesLater) {
  constexpr int most_later = 2;
  int found = 0;
  int waits = 0;
  int later = 0;
  for_each_scene([&](std::mt19937_64& rng) {
    auto [request, environment] = random_scene(rng);
    request.leg_tolerance = 0.0;  // nothing is paid for fewer legs, nor for holds in the place of short ones
    const Result<Plan> moving = plan(environment, without_holds(request));
    request.holds.longest = core::Seconds{support::uniform(rng, 0.5, 12.0) * hour_s};

    const Result<Plan> result = plan(environment, request);

    if (!result) {
      EXPECT_FALSE(moving) << "waiting is allowed, not asked for";
      return;
    }
    ++found;
    waits += waited(*result).count() > 0.0 ? 1 : 0;
    EXPECT_GT(least_gap_m(*result, environment, request.icebergs), -tolerance_m);
    for (const Waypoint& waypoint : result->waypoints) EXPECT_LE(waypoint.wait, request.holds.longest);
    later += moving && result->travel_time() > just_as_good * moving->travel_time() ? 1 : 0;
  });
  EXPECT_GT(found, scenes / 2);
  EXPECT_GE(waits, 2);
  EXPECT_LE(later, most_later);
}

INSTANTIATE_TEST_SUITE_P(Quarter, HoldsInAScene, testing::Range(0, 4));

TEST(Holds, WaitsForAZoneThatIsOpenedLater) {
  PlanRequest request = support::eastward_request();
  request.zones = {closed_at_first(20.0)};
  request.holds.longest = 2.0 * half_a_day;

  const Result<Plan> result = plan({}, request);

  ASSERT_TRUE(result) << result.error().explanation();
  // The straight route of 39.9 km takes 31.7 h; the zone begins 17.9 km, 14.2 h, from the start.
  EXPECT_NEAR(result->travel_time().count() / hour_s, 31.7 + 20.0 - 14.2, 0.3);
  EXPECT_NEAR(waited(*result).count() / hour_s, 20.0 - 14.2, 0.6);
}

TEST(Holds, IsNoLongerThanAllowedAtOnePlace) {
  PlanRequest request = support::eastward_request();
  request.from = {-53.07, 69.0};  // right before the zone, which no route leads round
  request.zones = {closed_at_first(20.0)};
  request.method = Method::direct;
  request.holds.longest = core::Seconds{10.0 * hour_s};
  EXPECT_FALSE(plan({}, request));

  request.holds.longest = core::Seconds{20.0 * hour_s};
  EXPECT_TRUE(plan({}, request));
}

TEST(Holds, DrawsEnergyAsIfUnderWay) {
  PlanRequest request = support::eastward_request();
  request.zones = {closed_at_first(20.0)};
  const Result<Plan> free = plan({}, support::eastward_request());
  request.holds.longest = 2.0 * half_a_day;

  const Result<Plan> result = plan({}, request);

  ASSERT_TRUE(free && result);
  const double power = free->energy->use.total().value / free->travel_time().count();
  EXPECT_NEAR(result->energy->use.total().value, power * result->travel_time().count(),
              1e-6 * result->energy->use.total().value);
  EXPECT_EQ(result->waypoints.back().energy->value, result->energy->use.total().value);
}

TEST(Holds, IsPossibleOnlyInACurrentThatLeavesTheVehicleAFifthOfItsSpeed) {
  // Slack water for five hours, then 0.5 m/s. The vehicle makes 0.35 m/s.
  const ocean::Environment environment{
      .currents = support::currents_from(
          [](geo::LonLat, double hour) { return geo::VelocityEn{{hour <= 5.0 ? 0.1 : 0.5}, {0.0}}; }, 48)};
  PlanRequest request = support::eastward_request();
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const plane::PlaneBox area{{-20'000.0, -10'000.0}, {20'000.0, 10'000.0}};
  const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};
  const geo::PlanePoint here{0.0, 0.0};
  const core::Seconds from{1.0 * hour_s};

  EXPECT_EQ(cost::can_stay_until(sea, here, from, core::Seconds{4.0 * hour_s}).count(), 4.0 * hour_s);
  // Between the hours the current grows evenly: 0.8 x 0.35 m/s at 5.45 h.
  EXPECT_NEAR(cost::can_stay_until(sea, here, from, core::Seconds{20.0 * hour_s}).count(), 5.45 * hour_s,
              900.0);
  EXPECT_LT(cost::can_stay_until(sea, here, core::Seconds{7.0 * hour_s}, core::Seconds{8.0 * hour_s}).count(),
            7.0 * hour_s);
  EXPECT_LT(
      cost::can_stay_until(sea, here, core::Seconds{47.0 * hour_s}, core::Seconds{60.0 * hour_s}).count(),
      48.1 * hour_s)
      << "the current is not known any longer";
}

TEST(Holds, EndsBeforeADiscTouchesItsCircle) {
  PlanRequest request = support::eastward_request();
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment;
  environment.icebergs = {drifting_berg({-53.2, 69.0}, 100.0, 0.2, 90.0)};
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const plane::PlaneBox area{{-20'000.0, -10'000.0}, {20'000.0, 10'000.0}};
  const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};

  const core::Seconds end =
      cost::can_stay_until(sea, {0.0, 0.0}, core::Seconds{0.0}, core::Seconds{48.0 * hour_s});

  // The berg is 7.98 km away; the disc's radius is 550 m, that of the hold circle 500 m.
  EXPECT_NEAR(end.count(), (7980.0 - 550.0 - 500.0) / 0.2, 300.0);
}

TEST(Holds, IsFoundForAGivenRouteToo) {
  auto [request, environment] = closed_gap();
  EXPECT_FALSE(evaluate_route(environment, {request.from, request.to}, without_holds(request)));
  // The vehicle would catch up with the berg. It leaves so late that the berg, at 0.12 m/s, will have passed the goal.
  request.holds.longest = 6.0 * half_a_day;

  const Result<Plan> result = evaluate_route(environment, {request.from, request.to}, request);

  ASSERT_TRUE(result) << result.error().explanation();
  const double passes_goal_h = (27'900.0 + 5550.0) / 0.12 / hour_s;
  EXPECT_NEAR(waited(*result).count() / hour_s, passes_goal_h - 31.7, 1.0);
  EXPECT_EQ(result->waypoints.size(), 2U);
}

/// Dense ice between two meridians, drafts of some metres, and open water elsewhere.
ocean::Environment ice_between(double west_deg, double east_deg) {
  return {
      .ice = support::ice_from(
          [=](geo::LonLat p, double) { return p.lon_deg > west_deg && p.lon_deg < east_deg ? 0.95 : 0.0; },
          {0.0, 72.0}, 1.0)};
}

TEST(Holds, LastsAsLongAsItMustWhereTheVehicleMaySurfaceMeanwhile) {
  PlanRequest request = support::eastward_request();
  request.zones = {closed_at_first(20.0)};
  request.holds.longest = 2.0 * half_a_day;
  const Result<Plan> free = plan({}, request);
  request.under_ice.max_time_without_surfacing = half_a_day;

  // The ice begins behind the zone, before which the vehicle waits.
  const Result<Plan> bound = plan(ice_between(-52.85, -52.7), request);

  ASSERT_TRUE(free && bound);
  EXPECT_GT(waited(*bound).count(), 4.0 * hour_s);
  EXPECT_NEAR(bound->travel_time().count(), free->travel_time().count(), 1e-3 * free->travel_time().count());
  ASSERT_TRUE(bound->surfacing);
  EXPECT_LE(bound->surfacing->longest_without, half_a_day);
}

TEST(Holds, CountsAsTimeWithoutASurfacingBelowIce) {
  PlanRequest request = support::eastward_request();
  request.zones = {closed_at_first(20.0)};
  request.holds.longest = 2.0 * half_a_day;
  const ocean::Environment environment = ice_between(-53.2, -52.9);
  request.under_ice.max_time_without_surfacing = 2.0 * half_a_day;
  const Result<Plan> patient = plan(environment, request);
  ASSERT_TRUE(patient && patient->surfacing);
  EXPECT_GT(waited(*patient).count(), 4.0 * hour_s);

  request.under_ice.max_time_without_surfacing = patient->surfacing->longest_without - core::Seconds{hour_s};
  const Result<Plan> result = plan(environment, request);

  if (result) {
    EXPECT_LE(result->surfacing->longest_without, *request.under_ice.max_time_without_surfacing);
  }
}

TEST(Holds, NeverKeepsTheVehicleFromTheSurfaceForLongerThanAllowed) {
  int found = 0;
  support::for_each_seed(8, [&](std::mt19937_64& rng) {
    PlanRequest request = support::eastward_request();
    request.spacing_along = core::Metres{2000.0};
    request.zones = {closed_at_first(support::uniform(rng, 8.0, 24.0))};
    request.holds.longest = support::uniform(rng, 0.5, 2.0) * half_a_day;
    request.under_ice.max_time_without_surfacing = support::uniform(rng, 0.3, 1.5) * half_a_day;
    const double west_deg = support::uniform(rng, -53.45, -52.7);
    const double east_deg = west_deg + support::uniform(rng, 0.05, 0.3);

    const Result<Plan> result = plan(ice_between(west_deg, east_deg), request);

    if (!result) return;
    ++found;
    constexpr core::Seconds between_looks{900.0};  // of a wait
    EXPECT_LE(result->surfacing->longest_without,
              *request.under_ice.max_time_without_surfacing + between_looks);
  });
  EXPECT_GT(found, 2);
}

TEST(Holds, AreNotBelowIceWhereTheTimeWithoutASurfacingIsNotBounded) {
  const PlanRequest request = support::eastward_request();
  const ocean::Environment environment = ice_between(-53.2, -52.9);
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const plane::PlaneBox area{{-30'000.0, -10'000.0}, {30'000.0, 10'000.0}};
  PlanRequest bounded = request;
  bounded.under_ice.max_time_without_surfacing = half_a_day;
  const core::Seconds hours{4.0 * hour_s};
  const auto stays = [&](const PlanRequest& asked, geo::PlanePoint place) {
    const cost::Sea sea{environment, asked, projection, area, core::Metres{500.0}};
    return cost::can_stay_until(sea, place, core::Seconds{0.0}, hours) >= hours;
  };

  EXPECT_FALSE(stays(request, {0.0, 0.0}));
  EXPECT_TRUE(stays(bounded, {0.0, 0.0}));
  EXPECT_TRUE(stays(request, {20'000.0, 0.0})) << "in open water";
}

TEST(Holds, HaveTheirLengthAndCircleChecked) {
  PlanRequest request = support::eastward_request();
  request.holds.longest = half_a_day;
  request.under_ice.max_time_without_surfacing = half_a_day;
  EXPECT_TRUE(request.violations().empty());

  request.holds.longest = core::Seconds{-1.0};
  EXPECT_EQ(request.violations().at(0).field, "/max_loiter_s");
  request.holds.longest = core::Seconds{NAN};
  EXPECT_EQ(request.violations().size(), 1U);
  request.holds = {.longest = half_a_day, .radius = core::Metres{20.0}};
  EXPECT_EQ(request.violations().at(0).field, "/hold_radius_m");
}

}  // namespace
}  // namespace floeplan::planning::plan_holds_test
