#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/planning/plan_arrival.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/plan_window.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::planner::progress_test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::Ge;
using testing::Le;
using testing::Lt;
using testing::SizeIs;

PlanRequest coarse_request() {
  PlanRequest request = support::eastward_request();
  request.spacing_along = core::Metres{2000.0};
  return request;
}

std::shared_ptr<const ocean::CurrentGrid> eastward(double speed_m_s) {
  return support::currents_from([=](geo::LonLat, double) { return geo::VelocityEn{{speed_m_s}, {0.0}}; },
                                120);
}

ocean::Environment three_members() {
  ocean::Environment environment{.currents = eastward(0.1)};
  environment.members = {eastward(0.1), eastward(0.0), eastward(-0.1)};
  return environment;
}

/// The shares that were reported, in their order.
struct Told {
  std::vector<double> all;
  std::vector<double> of_stage;

  core::ProgressCallback listener(std::string_view stage) {
    return [this, stage](std::string_view told, double share) {
      all.push_back(share);
      if (told == stage) of_stage.push_back(share);
    };
  }
};

void expect_never_falling(const Told& told) {
  EXPECT_TRUE(std::ranges::is_sorted(told.all)) << testing::PrintToString(told.all);
  EXPECT_THAT(told.all, Each(testing::AllOf(Ge(0.0), Le(1.0))));
}

std::vector<double> steps(const std::vector<double>& shares) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < shares.size(); ++i) steps.push_back(shares[i] - shares[i - 1]);
  return steps;
}

TEST(Progress, OfAWindowGrowsByTheSameWithEachDeparture) {
  PlanRequest request = coarse_request();
  request.departures.until = request.depart + core::Seconds{6 * 3600.0};
  request.departures.step = core::Seconds{3600.0};
  Told told;

  const WindowPlan window =
      plan_window({.currents = eastward(0.1)}, request, {}, told.listener("departures"), {});

  ASSERT_TRUE(window.plan.has_value());
  expect_never_falling(told);
  ASSERT_THAT(told.of_stage, SizeIs(1 + 7)) << "at the beginning, and with each departure";
  const std::vector<double> after_the_first = steps({told.of_stage.begin() + 1, told.of_stage.end()});
  EXPECT_THAT(after_the_first, Each(DoubleNear(after_the_first.front(), 1e-9)));
  EXPECT_GT(told.of_stage[1], after_the_first.front()) << "the grids are laid out with the first";
  EXPECT_LT(told.of_stage.back(), 0.7) << "the plan is still to be made";
}

TEST(Progress, OfAWindowInSeveralMembersNeverFalls) {
  PlanRequest request = coarse_request();
  request.departures.until = request.depart + core::Seconds{6 * 3600.0};
  request.departures.step = core::Seconds{3 * 3600.0};
  request.uncertainty.objective = RobustObjective::mean;
  Told told;

  const WindowPlan window = plan_window(three_members(), request, {}, told.listener("departures"), {});

  ASSERT_TRUE(window.plan.has_value());
  expect_never_falling(told);
  EXPECT_THAT(told.of_stage, SizeIs(1 + 12)) << "three departures in the first sea and in three members";
}

TEST(Progress, OfMembersCountsAPlanForEach) {
  PlanRequest request = coarse_request();
  request.uncertainty.objective = RobustObjective::mean;
  Told told;

  ASSERT_TRUE(plan_route(three_members(), request, {}, told.listener("members")).has_value());

  expect_never_falling(told);
  EXPECT_EQ(told.of_stage.size() + 1, told.all.size()) << "at last that it is done";
  // The first sea, the members, their mean; then each member for all candidates.
  const double work = 5.0 + 3 * 0.4;
  for (int plan = 0; plan <= 5; ++plan)
    EXPECT_THAT(told.all, testing::Contains(DoubleNear(plan / work, 1e-9)));
  EXPECT_EQ(told.all.back(), 1.0);
}

TEST(Progress, OfAWantedArrivalNeverFalls) {
  PlanRequest request = coarse_request();
  request.departures.arrive_by = request.depart + core::Seconds{3 * 86400.0};
  Told told;

  ASSERT_TRUE(plan_arrival({.currents = eastward(0.1)}, request, {}, told.listener("latest departure"), {})
                  .has_value());

  expect_never_falling(told);
  EXPECT_FALSE(told.of_stage.empty());
}

TEST(Progress, OfOrdersOfVisitsNeverFalls) {
  PlanRequest request = coarse_request();
  request.via = {{-53.3, 69.05}, {-52.9, 68.95}, {-53.1, 69.02}};
  request.via_in_best_order = true;
  Told told;

  ASSERT_TRUE(
      plan_route({.currents = eastward(0.1)}, request, {}, told.listener("order of visits")).has_value());

  expect_never_falling(told);
  EXPECT_FALSE(told.of_stage.empty());
}

TEST(Progress, OfMoreGridsNeverFallsAndLeavesThemHalf) {
  ocean::Environment fast_elsewhere;
  fast_elsewhere.currents = support::currents_from(
      [](geo::LonLat place, double) { return geo::VelocityEn{{place.lat_deg > 69.06 ? 1.0 : 0.1}, {0.0}}; },
      120);
  Told told;

  ASSERT_TRUE(plan_route(fast_elsewhere, coarse_request(), {}, told.listener("more grids")).has_value());

  expect_never_falling(told);
  ASSERT_FALSE(told.of_stage.empty()) << "more grids were tried";
  EXPECT_GE(told.of_stage.front(), 0.5);
}

/// Shallow water across the route from the south up to this latitude, deep water elsewhere.
ocean::Environment barrier_up_to(double lat_deg) {
  return {.bathymetry = support::bathymetry_from([=](geo::LonLat place) {
            return std::abs(place.lon_deg + 53.0) < 0.08 && place.lat_deg < lat_deg ? 5.0 : 300.0;
          })};
}

/// The first search area reaches 20 km to either side, the second one 40 km; the barrier ends between the two.
TEST(Progress, OfAWiderSearchAreaGoesOnInTheLastFifth) {
  const ocean::Environment environment = barrier_up_to(69.26);
  Told told;

  ASSERT_TRUE(plan_route(environment, coarse_request(), {}, told.listener("environment")).has_value());

  expect_never_falling(told);
  EXPECT_THAT(told.of_stage, ElementsAre(0.0, DoubleNear(0.8, 1e-9)));
  EXPECT_EQ(told.all.back(), 1.0);
}

TEST(Progress, OfAFailureNeverSaysDone) {
  const ocean::Environment environment = barrier_up_to(71.0);
  Told told;

  ASSERT_FALSE(plan_route(environment, coarse_request(), {}, told.listener("environment")).has_value());

  expect_never_falling(told);
  EXPECT_THAT(told.all, Each(Lt(1.0)));
}

/// The strategies themselves divide the progress; the rule that a reported share never falls has no effect
/// here.
TEST(Progress, OfStrategiesThatPlanMoreThanOnceNeverFalls) {
  PlanRequest cheapest = coarse_request();
  cheapest.energy.objective = energy_objective;
  cheapest.spacing_along.reset();
  PlanRequest safest = coarse_request();
  safest.icebergs.drift = false;
  safest.icebergs.max_inflation = core::Metres{0.0};
  safest.icebergs.encounter_weight = core::Seconds{86'400.0};
  PlanRequest surfacing = coarse_request();
  surfacing.under_ice.max_time_without_surfacing = core::Seconds{6.0 * 3600.0};
  ocean::Environment berg;
  berg.icebergs = {support::iceberg_at({-53.0, 68.995}, 100.0)};
  berg.icebergs[0].position_uncertainty = core::Metres{3000.0};
  const ocean::Environment ice{.ice = support::ice_from(
                                   [](geo::LonLat p, double) {
                                     return std::abs(p.lon_deg + 53.0) < 0.26 && p.lat_deg < 69.15 ? 0.9
                                                                                                   : 0.0;
                                   },
                                   {0.0}, 1.0)};

  for (const auto& [environment, request] :
       {std::pair{barrier_up_to(69.26), cheapest}, {berg, safest}, {ice, surfacing}}) {
    Told told;
    ASSERT_TRUE(try_to_plan(environment, request, {}, told.listener("search")).has_value());
    expect_never_falling(told);
    EXPECT_EQ(std::ranges::count(told.all, 1.0), 1) << "done is told once, at the end";
  }
}

}  // namespace
}  // namespace floeplan::planning::planner::progress_test
