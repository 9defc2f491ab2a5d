#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/planner/departure.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_without_holds_test {
namespace {

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

const Change* change_of(const Infeasible& infeasible, const std::string& input) {
  const auto found = std::ranges::find(infeasible.changes, input, &Change::input);
  return found == infeasible.changes.end() ? nullptr : &*found;
}

core::Seconds waited(const Plan& plan) {
  core::Seconds sum{0.0};
  for (const Waypoint& waypoint : plan.waypoints) sum += waypoint.wait;
  return sum;
}

/// A goal at about 10 km. A berg leaves it at a tenth of the vehicle's speed, and its disc grows to 5 km.
Scene goal_in_a_growing_disc() {
  PlanRequest request = support::eastward_request();
  request.to = {-53.25, 69.0};
  request.spacing_along = core::Metres{500.0};
  request.optimality_gap = false;
  request.holds.longest = core::Seconds{0.0};
  ocean::Environment environment;
  environment.icebergs = {drifting_berg(request.to, 100.0, 0.035, 0.0)};
  environment.icebergs[0].id = "B-17";
  return {request, environment};
}

/// The time when the disc, at its largest, has left the goal, with a minute for the curvature of the Earth.
core::Seconds opening(const PlanRequest& request) {
  return core::Seconds{(50.0 + (request.icebergs.margin + request.icebergs.max_inflation).value) / 0.035};
}

TEST(WithoutHolds, ThereIsNoPlanToAGoalThatOpensLater) {
  const auto [request, environment] = goal_in_a_growing_disc();

  const Result<Plan> result = plan(environment, request);

  ASSERT_FALSE(result) << result->travel_time().count() / hour_s << " h with " << result->waypoints.size();
  EXPECT_EQ(result.error().reason, Reason::goal_near_iceberg);
  EXPECT_EQ(result.error().binding, Constraint::iceberg);
  EXPECT_LT(geo::geodesic_between(result.error().at, request.to).length.value, 1.0);
  const std::string why = result.error().explanation();
  EXPECT_NE(why.find("iceberg B-17"), std::string::npos) << why;
  const std::string until = core::iso8601(start + opening(request));
  EXPECT_NE(why.find(", until " + until.substr(0, 13)), std::string::npos) << why;
}

ocean::Zone closed_area(double west, double east) {
  return {.name = "area",
          .kind = ocean::ZoneKind::no_go,
          .area = {.outer = {{west, 67.6}, {east, 67.6}, {east, 70.4}, {west, 70.4}}, .holes = {}},
          .from = {},
          .until = {}};
}

TEST(WithoutHolds, TheAreaIsBlamedThatKeepsTheGoal) {
  auto [request, environment] = goal_in_a_growing_disc();
  request.zones = {closed_area(-53.26, -53.24)};
  request.zones[0].until = start + opening(request) + core::Seconds{36'000.0};

  const Result<Plan> result = plan(environment, request);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::goal_in_zone);
  EXPECT_EQ(result.error().binding, Constraint::zone);
  const std::string why = result.error().explanation();
  EXPECT_NE(why.find(", until " + core::iso8601(*request.zones[0].until).substr(0, 13)), std::string::npos)
      << why;
}

TEST(WithoutHolds, TheGoalIsNotBlamedWhereAnAreaClosesTheWayForGood) {
  auto [request, environment] = goal_in_a_growing_disc();
  request.zones = {closed_area(-53.41, -53.39)};
  request.zones[0].from = start + core::Seconds{3600.0};

  const Result<Plan> result = plan(environment, request);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::goal_unreachable);
  EXPECT_EQ(result.error().binding, Constraint::zone);
  EXPECT_EQ(result.error().explanation().find("the goal lies"), std::string::npos)
      << result.error().explanation();
}

TEST(WithoutHolds, ALaterDepartureIsNamed) {
  auto [request, environment] = goal_in_a_growing_disc();
  const Result<Plan> refused = plan(environment, request);
  ASSERT_FALSE(refused);

  const Change* later = change_of(refused.error(), "depart");

  ASSERT_NE(later, nullptr);
  const core::Seconds way{9'980.0 / 0.35};
  EXPECT_LE((std::get<core::UtcTime>(later->to) - start).count(), (opening(request) - way).count() + 7200.0);
  request.depart = std::get<core::UtcTime>(later->to);
  const Result<Plan> result = plan(environment, request);
  ASSERT_TRUE(result);
  EXPECT_GT(least_gap_m(*result, environment, request.icebergs), -50.0);
}

TEST(WithoutHolds, ALeaveToHoldIsNamed) {
  auto [request, environment] = goal_in_a_growing_disc();
  for (const double hours : {0.0, 0.5}) {
    request.holds.longest = core::Seconds{hours * hour_s};
    const Result<Plan> refused = plan(environment, request);
    ASSERT_FALSE(refused) << hours;

    const Change* hold = change_of(refused.error(), "max_loiter_s");

    ASSERT_NE(hold, nullptr) << hours;
    PlanRequest holding = request;
    holding.holds.longest = core::Seconds{std::get<double>(hold->to)};
    const Result<Plan> result = plan(environment, holding);
    ASSERT_TRUE(result);
    EXPECT_NEAR(waited(*result).count(), (opening(request) - core::Seconds{9'980.0 / 0.35}).count(), 7200.0);
    EXPECT_LT(result->distance.value, 16'000.0);
    EXPECT_GT(least_gap_m(*result, environment, request.icebergs), -50.0);
  }
}

TEST(WithoutHolds, ADepartureOfAWindowMayBeTooEarly) {
  auto [request, environment] = goal_in_a_growing_disc();
  request.departures.until = start + core::Seconds{48.0 * hour_s};
  request.departures.step = core::Seconds{16.0 * hour_s};

  const auto outcomes = planner::compare_departures(environment, request, {}, {});

  ASSERT_TRUE(outcomes);
  ASSERT_EQ(outcomes->size(), 4U);
  EXPECT_FALSE(outcomes->front().travel_time);
  EXPECT_TRUE(outcomes->front().closed);
  EXPECT_TRUE(outcomes->back().travel_time);
}

TEST(WithoutHolds, TheVehicleGoesRoundWhatOpensLaterAndThePlanSaysSo) {
  // A no-go area lies across the straight line for half a day. To go round it takes longer than to hold until it reopens.
  PlanRequest request = support::eastward_request();
  request.to = {-53.3, 69.0};
  request.spacing_along = core::Metres{500.0};
  request.optimality_gap = false;
  request.holds.longest = core::Seconds{0.0};
  const Result<Plan> free = plan({}, request);
  const core::Seconds until{9.0 * hour_s};
  request.zones = {
      {.name = "trawlers",
       .kind = ocean::ZoneKind::no_go,
       .area = {.outer = {{-53.42, 68.93}, {-53.38, 68.93}, {-53.38, 69.07}, {-53.42, 69.07}}, .holes = {}},
       .from = std::nullopt,
       .until = start + until}};

  const Result<Plan> result = plan({}, request);

  ASSERT_TRUE(free && result);
  EXPECT_GT(result->travel_time(), 0.5 * free->travel_time() + until) << "later than with a hold";
  const auto& points = result->waypoints;
  EXPECT_TRUE(
      std::ranges::any_of(points, [](const Waypoint& p) { return std::abs(p.place.lat_deg - 69.0) > 0.06; }));
  EXPECT_TRUE(std::ranges::any_of(result->messages, [](const messages::Message& message) {
    return message.code == "route-without-holds";
  }));
}

}  // namespace
}  // namespace floeplan::planning::plan_without_holds_test
