#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/cost/surfacing.hpp"
#include "engine/planning/ice/nearest_ice.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_under_ice_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const core::ProgressCallback quiet = [](std::string_view, double) {};

/// About 40 km eastwards; ice of 90 % between 53.25 W and 52.75 W, open north of 69.15 N.
ocean::Environment band_of_ice() {
  return {.ice = support::ice_from(
              [](geo::LonLat p, double) {
                return std::abs(p.lon_deg + 53.0) < 0.26 && p.lat_deg < 69.15 ? 0.9 : 0.0;
              },
              {0.0}, 1.0)};
}

/// About 75 km of ice of 90 % eastwards, with holes of 5 km strewn over it, and a tide.
ocean::Environment ice_with_holes(int seed, int count) {
  std::mt19937_64 rng{static_cast<std::uint64_t>(seed)};
  std::vector<geo::LonLat> holes;
  for (int i = 0; i < count; ++i)
    holes.push_back({support::uniform(rng, -54.2, -51.8), support::uniform(rng, 68.6, 69.4)});
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, support::steps(-56.0, 0.03, 200),
                                   support::steps(67.5, 0.015, 200)};
  ocean::IceField::Samples samples{
      .grid = grid, .times_s = ocean::Axis{{support::sea_start_s}}, .concentration = {}, .thickness_m = {}};
  for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
      const geo::LonLat place = grid.place(ix, iy);
      const bool is_open =
          std::abs(place.lon_deg + 53.0) > 0.95 || std::ranges::any_of(holes, [&](geo::LonLat hole) {
            return geo::geodesic_between(place, hole).length.value < 2500.0;
          });
      samples.concentration.push_back(is_open ? 0.0F : 0.9F);
      samples.thickness_m.push_back(1.0F);
    }
  }
  const auto tide = [](geo::LonLat place, double hour) {
    const double phase = 2.0 * std::numbers::pi * hour / 12.42;
    return geo::VelocityEn{{0.1 * std::cos(phase + 9.0 * place.lat_deg)},
                           {0.1 * std::sin(phase + 5.0 * place.lon_deg)}};
  };
  return {.currents = support::currents_from(tide, 120),
          .ice = std::make_shared<const ocean::IceField>(std::move(samples))};
}

Plan planned(const ocean::Environment& environment, const PlanRequest& request) {
  const auto plan = plan_route(environment, request, {}, quiet);
  if (plan) return *plan;
  ADD_FAILURE() << reason_name(plan.error().reason) << ": " << plan.error().explanation();
  return {};
}

TEST(PlanUnderIce, WarnsOfDeeperIceWithinTheErrorOfPosition) {
  // Ice covers everything except the ends of the route. In one half of the sea its keels are deep.
  const auto sea_with = [](double dense_from_lat) {
    ocean::Environment sea;
    sea.ice = support::ice_from(
        [=](geo::LonLat place, double) {
          if (std::abs(place.lon_deg + 53.0) > 0.35) return 0.0;
          return place.lat_deg > dense_from_lat ? 1.0 : 0.0;
        },
        {0.0, 100.0, 200.0}, 10.0);
    return sea;
  };
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  const auto warns = testing::Contains(testing::HasSubstr("may come below the ice beside the route"));

  EXPECT_THAT(messages::sentences(planner::try_to_plan(sea_with(60.0), request, {}, {}).value().messages),
              testing::Not(warns));
  request.under_ice.surfacing_interval = core::Seconds{86'400.0};
  EXPECT_THAT(messages::sentences(planner::try_to_plan(sea_with(69.02), request, {}, {}).value().messages),
              warns);
}

TEST(PlanUnderIce, WarnsOfOpeningsThatKeepTheBoundAndMayBeMissed) {
  // 15 km of ice on either side of a lead, whose middle is 2.4 km from the ice. The position error is 3 km there.
  const ocean::Environment sea{.ice = support::ice_from(
                                   [](geo::LonLat place, double) {
                                     if (std::abs(place.lon_deg + 52.95) < 0.06) return 0.0;
                                     return std::abs(place.lon_deg + 52.95) < 0.4 ? 1.0 : 0.0;
                                   },
                                   {0.0}, 1.0)};
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  const auto warns = testing::Contains(testing::HasSubstr("only if the vehicle finds leads"));

  EXPECT_THAT(messages::sentences(planned(sea, request).messages), testing::Not(warns))
      << "there is no limit";
  request.under_ice.max_time_without_surfacing = core::Seconds{15.0 * 3600.0};
  const Plan bounded = planned(sea, request);
  EXPECT_THAT(messages::sentences(bounded.messages), warns);
  const auto told = std::ranges::find(bounded.messages, "leads-may-be-missed", &messages::Message::code);
  ASSERT_NE(told, bounded.messages.end());
  EXPECT_EQ(told->rank, messages::Rank::danger) << "beyond the pilot's own limit";
  ASSERT_TRUE(told->place);
  EXPECT_NEAR(told->place->lon_deg, -52.95, 0.1) << "the lead";
  request.under_ice.current_uncertainty = {0.0};
  EXPECT_THAT(messages::sentences(planned(sea, request).messages), testing::Not(warns))
      << "less off than the opening is wide";
}

TEST(PlanUnderIce, TellsWithoutALimitHowLongTheVehicleIsBelowIceIfItMissesLeads) {
  const auto sea_with_lead = [](double half_width_deg) {
    return ocean::Environment{.ice = support::ice_from(
                                  [=](geo::LonLat place, double) {
                                    if (std::abs(place.lon_deg + 53.0) < half_width_deg) return 0.0;
                                    return std::abs(place.lon_deg + 53.0) < 0.4 ? 1.0 : 0.0;
                                  },
                                  {0.0}, 1.0)};
  };
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  const auto told = [&](double half_width_deg) {
    const Plan plan = planned(sea_with_lead(half_width_deg), request);
    const auto found =
        std::ranges::find(plan.messages, "longer-below-ice-without-leads", &messages::Message::code);
    return found != plan.messages.end() && found->rank == messages::Rank::danger;
  };

  EXPECT_TRUE(told(0.06)) << "a lead narrower than the position error";
  EXPECT_FALSE(told(0.25)) << "a lead that it cannot miss";
  EXPECT_FALSE(told(-1.0)) << "no lead: the planned time is as long";
}

TEST(PlanUnderIce, WarnsOfEscapesThatEndAtTheEdgeOfTheIce) {
  PlanRequest request = support::eastward_request();
  request.max_leg = core::Metres{4000.0};
  request.under_ice.escape_plan = true;
  const auto warns = testing::Contains(testing::HasSubstr("end closer to ice than the position error"));

  EXPECT_THAT(messages::sentences(planned(band_of_ice(), request).messages), warns);
  request.under_ice.current_uncertainty = {0.0};
  request.under_ice.dead_reckoning_share = 0.0;
  EXPECT_THAT(messages::sentences(planned(band_of_ice(), request).messages), testing::Not(warns))
      << "whose position is certain";
  ocean::Environment with_currents = band_of_ice();
  with_currents.currents = support::currents_from(
      [](geo::LonLat place, double) {
        return geo::VelocityEn{{0.0}, {std::abs(place.lon_deg + 53.0) < 0.2 ? 0.1 : 0.0}};
      },
      120);
  EXPECT_THAT(messages::sentences(planned(with_currents, request).messages), warns)
      << "a current that it has not measured";
}

TEST(PlanUnderIce, PassesBelowTheIceWhenNothingBoundsTheTimeThere) {
  const Plan plan = planned(band_of_ice(), support::eastward_request());

  ASSERT_TRUE(plan.surfacing);
  EXPECT_EQ(plan.waypoints.size(), 2U);
  EXPECT_NEAR(plan.surfacing->longest_without.count() / 3600.0, 17.7, 2.0);
  EXPECT_TRUE(plan.surfacing->surfacings.empty());
  EXPECT_EQ(plan.surfacing->waypoints.size(), plan.waypoints.size());
}

TEST(PlanUnderIce, GoesRoundTheIceWhenTheTimeBelowItWouldBeTooLong) {
  PlanRequest request = support::eastward_request();
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * 6.0};

  const Plan plan = planned(band_of_ice(), request);

  ASSERT_TRUE(plan.surfacing);
  EXPECT_LE(plan.surfacing->longest_without.count(), 3600.0 * 6.0);
  EXPECT_GT(plan.waypoints.size(), 2U);
  double northernmost = 0.0;
  for (const Waypoint& waypoint : plan.waypoints)
    northernmost = std::max(northernmost, waypoint.place.lat_deg);
  EXPECT_GT(northernmost, 69.1);
  EXPECT_GT(plan.arrival, planned(band_of_ice(), support::eastward_request()).arrival);
}

TEST(PlanUnderIce, TellsHowDeepTheDivesTurnOnALegWhoseEndsLieInOpenWater) {
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  request.refine = false;

  const Plan below = planned(band_of_ice(), request);
  const Plan open =
      planned({.ice = support::ice_from([](geo::LonLat, double) { return 0.0; }, {0.0}, 1.0)}, request);

  ASSERT_EQ(below.surfacing->waypoints.size(), 2U);
  const SurfacingState& goal = below.surfacing->waypoints.back();
  EXPECT_TRUE(goal.may_surface);
  EXPECT_EQ(goal.least_upper_turn.value, 0.0);
  ASSERT_TRUE(goal.leg_upper_turn.has_value());
  EXPECT_NEAR(goal.leg_upper_turn->value, 18.0, 1e-4);
  EXPECT_FALSE(below.surfacing->waypoints.front().leg_upper_turn.has_value());
  EXPECT_EQ(open.surfacing->waypoints.back().leg_upper_turn, core::Metres{0.0});
}

TEST(PlanUnderIce, TellsHowFarBeyondTheIceItsWaypointsLie) {
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  request.refine = false;

  const Plan below = planned(band_of_ice(), request);
  const Plan open =
      planned({.ice = support::ice_from([](geo::LonLat, double) { return 0.0; }, {0.0}, 1.0)}, request);

  const SurfacingState& goal = below.surfacing->waypoints.back();
  const geo::LonLat end = below.waypoints.back().place;
  const geo::GeodesicLine back = geo::geodesic_between(end, below.waypoints.front().place);
  double open_m = 0.0;  // looked up in the ice itself
  while (band_of_ice()
             .ice->at(geo::geodesic_destination(end, back.course_at_start, {open_m}), below.departure)
             ->concentration <= request.under_ice.max_concentration_to_surface)
    open_m += 10.0;
  EXPECT_LE(goal.ice_free_before->value, open_m + 1.0);
  EXPECT_GT(goal.ice_free_before->value, open_m - 500.0);
  EXPECT_NEAR(open.surfacing->waypoints.back().ice_free_before->value, open.distance.value, 1.0);
  const double through_water_m = request.vehicle.speed_through_water.value * below.travel_time().count();
  const double by_currents_m = request.under_ice.current_uncertainty.value * below.travel_time().count();
  EXPECT_NEAR(goal.error_without_fix->value,
              request.under_ice.dead_reckoning_share * through_water_m + by_currents_m, 1.0);
  EXPECT_LT(goal.position_error.value, goal.error_without_fix->value);
}

/// Both ends of the only leg lie in open water, and so does most of the leg.
TEST(PlanUnderIce, CountsTheStretchesBelowIceRatherThanWholeLegs) {
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  request.refine = false;

  const Plan below = planned(band_of_ice(), request);

  double dense_m = 0.0;  // looked up in the ice itself
  const geo::LonLat start = below.waypoints.front().place;
  const geo::GeodesicLine ahead = geo::geodesic_between(start, below.waypoints.back().place);
  for (double along_m = 5.0; along_m < ahead.length.value; along_m += 10.0) {
    const auto ice = band_of_ice().ice->at(geo::geodesic_destination(start, ahead.course_at_start, {along_m}),
                                           below.departure);
    if (ice->concentration > request.under_ice.max_concentration_to_surface) dense_m += 10.0;
  }
  const SurfacingPlan& surfacing = *below.surfacing;
  ASSERT_EQ(surfacing.below_ice->size(), 1U);
  EXPECT_LT(dense_m, 0.7 * below.distance.value);
  EXPECT_NEAR(length_below_ice(surfacing)->value, dense_m, 500.0) << "half a check at either end";
  EXPECT_LE(time_below_ice(surfacing)->count(), surfacing.longest_without.count());
  EXPECT_NEAR(time_below_ice(surfacing)->count(),
              length_below_ice(surfacing)->value / below.waypoints.back().speed_over_ground->value, 60.0);
}

TEST(PlanUnderIce, IsBelowIceAllTheWayOrNowhere) {
  const auto everywhere = [](double concentration) {
    return ocean::Environment{
        .ice = support::ice_from([=](geo::LonLat, double) { return concentration; }, {0.0}, 1.0)};
  };
  PlanRequest request = support::eastward_request();
  request.max_leg = core::Metres{9000.0};

  const Plan below = planned(everywhere(1.0), request);
  const Plan open = planned(everywhere(0.0), request);

  EXPECT_GT(below.waypoints.size(), 3U);
  EXPECT_EQ(below.surfacing->below_ice->size(), below.waypoints.size() - 1) << "one for each leg";
  EXPECT_NEAR(length_below_ice(*below.surfacing)->value, below.distance.value, 1.0);
  EXPECT_NEAR(time_below_ice(*below.surfacing)->count(), below.travel_time().count(), 1.0);
  EXPECT_TRUE(open.surfacing->below_ice->empty());
  EXPECT_EQ(length_below_ice(*open.surfacing)->value, 0.0);
}

/// Law: under ice everywhere the vehicle needs the same energy as in open water with dives that turn at the same depth.
TEST(PlanUnderIce, DrawsWhatDivesDrawThatTurnBelowTheIce) {
  const ocean::Environment thick{.ice =
                                     support::ice_from([](geo::LonLat, double) { return 1.0; }, {0.0}, 6.0)};
  const PlanRequest request = support::eastward_request();
  const Plan below = planned(thick, request);
  PlanRequest deeper = request;
  deeper.vehicle.climb_to = below.surfacing->waypoints.front().least_upper_turn;
  ASSERT_GT(deeper.vehicle.climb_to.value, 40.0);

  const EnergyUse drawn = below.energy->use;
  const EnergyUse in_open_water = planned({}, deeper).energy->use;

  EXPECT_NEAR(drawn.pump.value, in_open_water.pump.value, 1e-4 * in_open_water.pump.value);
  EXPECT_NEAR(drawn.inflections, in_open_water.inflections, 1e-4 * in_open_water.inflections);
  EXPECT_GT(drawn.pump.value, 1.2 * planned({}, request).energy->use.pump.value);
  EXPECT_NEAR(below.waypoints.back().energy->value, drawn.total().value, 1e-6 * drawn.total().value);
  EXPECT_THAT(messages::sentences(below.messages), Not(Contains(HasSubstr("but its times are those of dives with"))));
}

/// Law: under ice everywhere the current carries it as in open water with dives that turn at the same depth.
TEST(PlanUnderIce, DriftsWithTheCurrentsOfDivesThatTurnBelowTheIce) {
  ocean::Environment sheared{.currents = support::sheared_currents(), .steady_currents = true};
  const PlanRequest request = support::eastward_request();
  const auto in_open_water = [&](core::Metres climb_to) {
    PlanRequest deeper = request;
    deeper.vehicle.climb_to = climb_to;
    return planned(sheared, deeper).travel_time();
  };
  ocean::Environment covered = sheared;
  covered.ice = support::ice_from([](geo::LonLat, double) { return 1.0; }, {0.0}, 6.0);

  const Plan below = planned(covered, request);

  const core::Metres turn{std::ceil(below.surfacing->waypoints.front().least_upper_turn.value)};
  EXPECT_NEAR(below.travel_time() / in_open_water(turn), 1.0, 1e-6);
  EXPECT_GT(below.travel_time() / in_open_water(request.vehicle.climb_to), 1.1);
}

/// Ice so thick that half of the dives is left lies on the straight route; beside it energy is as anywhere.
TEST(PlanUnderIce, SavesEnergyByGoingRoundThickIce) {
  const ocean::Environment thick{
      .ice = support::ice_from(
          [](geo::LonLat p, double) {
            return std::abs(p.lon_deg + 53.0) < 0.3 && std::abs(p.lat_deg - 69.0) < 0.03 ? 1.0 : 0.0;
          },
          {0.0}, 12.0)};
  PlanRequest request = support::eastward_request();
  const Plan fastest = planned(thick, request);
  request.energy.objective = energy_objective;

  const Plan thriftiest = planned(thick, request);

  EXPECT_LT(thriftiest.energy->use.total().value, 0.98 * fastest.energy->use.total().value);
  EXPECT_GT(thriftiest.travel_time(), fastest.travel_time());
}

TEST(PlanUnderIce, DrawsForEachPlannedSurfacing) {
  PlanRequest request = support::eastward_request();
  const Plan without = planned(band_of_ice(), request);
  request.under_ice.surfacing_interval = core::Seconds{3600.0};

  const Plan with = planned(band_of_ice(), request);

  const auto count = static_cast<double>(with.surfacing->surfacings.size());
  ASSERT_GT(count, 3.0);
  EXPECT_NEAR(with.energy->use.total().value - without.energy->use.total().value,
              count * request.vehicle.energy.surfacing.value, 1.0);
  EXPECT_NEAR(with.waypoints.back().energy->value, with.energy->use.total().value, 1.0);
}

TEST(PlanUnderIce, KeepsLegsShortWhereTheTimeBelowTheIceIsBounded) {
  PlanRequest request = support::eastward_request();
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * 6.0};
  request.max_leg = core::Metres{2000.0};

  const Plan plan = planned(band_of_ice(), request);

  EXPECT_LE(plan.surfacing->longest_without.count(), 3600.0 * 6.0);
  for (const Waypoint& waypoint : plan.waypoints)
    EXPECT_LE(waypoint.leg_length.value_or(core::Metres{0.0}).value, 2001.0);
}

TEST(PlanUnderIce, BlamesTheIceWhereAPlaceToPassLeavesNoTimeToGoOn) {
  const ocean::Environment closed{
      .ice =
          support::ice_from([](geo::LonLat p, double) { return p.lon_deg > -53.3 ? 0.9 : 0.0; }, {0.0}, 1.0)};
  PlanRequest request = support::eastward_request();
  request.via = {{-53.2, 69.0}};  // 3.2 h below the ice
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * 3.6};

  const auto plan = plan_route(closed, request, {}, quiet);

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().reason, Reason::no_surfacing);
  EXPECT_EQ(plan.error().binding, Constraint::ice);
}

/// The best route to the via point is straight on. It leaves too little of the bound for the rest of the
/// route.
TEST(PlanUnderIce, SurfacesBeforeAPlaceToPassWhereItMustGoOnBelowTheIce) {
  const geo::LonLat hole{-53.25, 69.06};
  ocean::Environment holed{.ice = support::ice_from(
                               [&](geo::LonLat p, double) {
                                 const double to_hole_m = geo::geodesic_between(p, hole).length.value;
                                 return p.lon_deg < -53.4 || to_hole_m < 4000.0 ? 0.0 : 0.9;
                               },
                               {0.0}, 1.0)};
  // Energy is not even, so that it has a search of its own.
  holed.bathymetry = support::bathymetry_from([](geo::LonLat p) { return p.lat_deg > 69.02 ? 60.0 : 400.0; });
  PlanRequest request = support::eastward_request();
  request.via = {{-53.1, 69.0}};  // 11.6 h below the ice, and 8.8 h to go
  request.to = {-52.85, 69.0};
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * 18.0};
  for (const Objective& objective : {time_objective, energy_objective}) {
    request.energy.objective = objective;

    const Plan plan = planned(holed, request);

    ASSERT_TRUE(plan.surfacing);
    EXPECT_LE(plan.surfacing->longest_without.count(), 3600.0 * 18.0);
  }
}

/// The lower bound of the time from the via point to the goal, with the strongest current astern, is much less than the
/// true time.
TEST(PlanUnderIce, LeavesAsMuchOfTheBoundAtAPlaceToPassAsTheWayOnTakesInATide) {
  const geo::LonLat hole{-53.25, 69.06};
  const auto tide = [](geo::LonLat, double hour) {
    return geo::VelocityEn{{0.2 * std::cos(2.0 * std::numbers::pi * hour / 12.42)}, {0.0}};
  };
  const ocean::Environment holed{.currents = support::currents_from(tide, 240),
                                 .ice = support::ice_from(
                                     [&](geo::LonLat p, double) {
                                       const double to_hole_m = geo::geodesic_between(p, hole).length.value;
                                       return p.lon_deg < -53.4 || to_hole_m < 4000.0 ? 0.0 : 0.9;
                                     },
                                     {0.0}, 1.0)};
  PlanRequest request = support::eastward_request();
  request.spacing_along = core::Metres{1000.0};
  request.via = {{-53.1, 69.0}};  // some 10 h below the ice, and 8 h to go
  request.to = {-52.85, 69.0};
  for (const double bound_h : {14.0, 16.0}) {
    request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * bound_h};

    const Plan plan = planned(holed, request);

    ASSERT_TRUE(plan.surfacing) << "within " << bound_h << " h";
    EXPECT_LE(plan.surfacing->longest_without.count(), 3600.0 * bound_h);
  }
}

/// With the default spacing, 400 m for this route, the search reaches its limit long before it finds the best route.
TEST(PlanUnderIce, SearchesACoarserGridWhereTheOneLeftOpenTakesTooMuchMemory) {
  const ocean::Environment environment = ice_with_holes(3, 14);
  PlanRequest request = support::eastward_request();
  request.from = {-53.99, 69.0};
  request.to = {-52.01, 69.0};
  request.optimality_gap = false;
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * 24.0};
  request.spacing_along = core::Metres{400.0};
  const Plan on_the_usual_grid = planned(environment, request);
  ASSERT_TRUE(on_the_usual_grid.search.cut_short);
  request.spacing_along.reset();

  const Plan plan = planned(environment, request);

  EXPECT_LT(plan.travel_time() / on_the_usual_grid.travel_time(), 0.995);
  EXPECT_LE(plan.surfacing->longest_without.count(), 3600.0 * 24.0);
}

/// A grid on which a route is found within seconds.
PlanRequest from_hole_to_hole(double most_hours_below_ice) {
  PlanRequest request = support::eastward_request();
  request.optimality_gap = false;
  request.spacing_along = core::Metres{2500.0};
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * most_hours_below_ice};
  return request;
}

/// Routes from lead to lead: refinement must not move the places to surface.
TEST(PlanUnderIce, MovesWaypointsOffTheGridWhereTheTimeBelowTheIceIsBounded) {
  const ocean::Environment environment = ice_with_holes(3, 40);
  PlanRequest request = from_hole_to_hole(10.0);
  const Plan refined = planned(environment, request);
  request.refine = false;
  const Plan on_the_grid = planned(environment, request);

  EXPECT_TRUE(refined.refinement);
  EXPECT_LE(refined.surfacing->longest_without.count(), 3600.0 * 10.0);
  EXPECT_LT(refined.travel_time() / on_the_grid.travel_time(), 0.98);
}

TEST(PlanUnderIce, ABoundThatTheBestWayKeepsChangesNothing) {
  const Plan free = planned(band_of_ice(), support::eastward_request());
  PlanRequest request = support::eastward_request();
  request.under_ice.max_time_without_surfacing = 1.1 * free.surfacing->longest_without;

  const Plan bounded = planned(band_of_ice(), request);

  EXPECT_EQ(bounded.arrival, free.arrival);
  ASSERT_EQ(bounded.waypoints.size(), free.waypoints.size());
  for (std::size_t i = 0; i < free.waypoints.size(); ++i)
    EXPECT_EQ(bounded.waypoints[i].place, free.waypoints[i].place);
  EXPECT_EQ(bounded.search.expansions, free.search.expansions);
}

TEST(PlanUnderIce, SaysWhereTheVehicleWouldBeTooLongWithoutASurfacing) {
  PlanRequest request = support::eastward_request();
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * 3.0};
  const ocean::Environment closed{
      .ice =
          support::ice_from([](geo::LonLat p, double) { return p.lon_deg > -53.3 ? 0.9 : 0.0; }, {0.0}, 1.0)};

  const auto plan = plan_route(closed, request, {}, quiet);

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().reason, Reason::no_surfacing);
  EXPECT_THAT(plan.error().explanation(), HasSubstr("for more than 3 h"));
}

TEST(PlanUnderIce, TheStraightWayIsHeldToTheSameBound) {
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * 6.0};

  const auto plan = plan_route(band_of_ice(), request, {}, quiet);

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().reason, Reason::no_surfacing);
}

TEST(PlanUnderIce, EveryObjectiveKeepsTheBoundAndHasItsEscapes) {
  ocean::Environment environment = band_of_ice();
  // Pumping costs more over the bank in the north, so the cheapest route leads through the ice.
  environment.bathymetry =
      support::bathymetry_from([](geo::LonLat p) { return p.lat_deg > 69.1 ? 60.0 : 400.0; });
  environment.icebergs = {support::iceberg_at({-53.0, 69.2}, 200.0)};
  PlanRequest request = support::eastward_request();
  request.under_ice.escape_plan = true;
  const auto longest_without = [&](const PlanRequest& asked) {
    const Plan plan = planned(environment, asked);
    EXPECT_EQ(plan.surfacing->escapes.size(), plan.waypoints.size());
    for (const EscapeWay& escape : plan.surfacing->escapes)
      EXPECT_EQ(escape.drives.size() + 1, escape.way.size());
    return plan.surfacing->longest_without.count();
  };
  std::vector<PlanRequest> requests(4, request);
  requests[0].energy.objective = energy_objective;
  requests[1].energy.objective = {1.0, 0.01};
  requests[2].energy.objective = energy_objective;
  requests[2].vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  requests[3].icebergs.encounter_weight = core::Seconds{3600.0};

  for (PlanRequest& each : requests) {
    const double bound_s = 3600.0 * 6.0;
    EXPECT_GT(longest_without(each), bound_s);
    each.under_ice.max_time_without_surfacing = core::Seconds{bound_s};
    EXPECT_LE(longest_without(each), bound_s);
  }
}

TEST(PlanUnderIce, TheErrorOfThePositionGrowsUntilTheVehicleMaySurfaceAgain) {
  PlanRequest request = support::eastward_request();
  request.to = {-53.0, 69.0};  // in the ice
  request.under_ice.dead_reckoning_share = 0.1;
  request.under_ice.current_uncertainty = core::MetresPerSecond{0.05};

  const Plan plan = planned(band_of_ice(), request);

  const SurfacingState& goal = plan.surfacing->waypoints.back();
  EXPECT_FALSE(goal.may_surface);
  EXPECT_NEAR(goal.position_error.value, (0.1 * 0.35 + 0.05) * goal.since_surfacing.count(), 1e-6);
  EXPECT_NEAR(goal.least_upper_turn.value, 18.0, 1e-4);
  EXPECT_EQ(plan.surfacing->waypoints.front().position_error.value, 0.0);
  EXPECT_THAT(messages::sentences(plan.messages), Contains(HasSubstr("the goal lies under ice")));
}

/// Straight on to a goal in ice, in which the current runs northwards at `in_ice_m_s`, and with `outside_m_s` in front
/// of it.
Plan planned_into_ice_with_currents(const ocean::Environment& ice, double outside_m_s, double in_ice_m_s) {
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  request.to = {-53.0, 69.0};
  ocean::Environment sea = ice;
  sea.currents = support::currents_from(
      [=](geo::LonLat place, double) {
        return geo::VelocityEn{{0.0}, {place.lon_deg > -53.26 ? in_ice_m_s : outside_m_s}};
      },
      96);
  return planned(sea, request);
}

core::Metres grown_by_the_rules(const SurfacingState& state) {
  return {(0.06 * 0.35 + 0.05) * state.since_surfacing.count()};
}

TEST(PlanUnderIce, TheErrorCountsWhatCurrentsCarryWhoHasNotMeasuredThem) {
  const ocean::Environment everywhere{
      .ice = support::ice_from([](geo::LonLat, double) { return 0.9; }, {0.0}, 1.0)};

  const Plan plan = planned_into_ice_with_currents(everywhere, 0.15, 0.15);

  const SurfacingState& goal = plan.surfacing->waypoints.back();
  const double carried_m = 0.15 * plan.travel_time().count();
  EXPECT_NEAR(goal.position_error.value, grown_by_the_rules(goal).value + carried_m, 0.01 * carried_m);
}

TEST(PlanUnderIce, TheErrorDoesNotCountACurrentThatWasMeasuredBeforeTheDive) {
  const Plan steady = planned_into_ice_with_currents(band_of_ice(), 0.15, 0.15);
  const SurfacingState& goal = steady.surfacing->waypoints.back();
  EXPECT_NEAR(goal.position_error.value, grown_by_the_rules(goal).value, 50.0);

  const Plan turned = planned_into_ice_with_currents(band_of_ice(), -0.15, 0.15);
  const SurfacingState& off = turned.surfacing->waypoints.back();
  const double carried_m = 0.3 * off.since_surfacing.count();
  const double against_m = off.position_error.value - grown_by_the_rules(off).value;
  EXPECT_LT(against_m, carried_m);
  EXPECT_GT(against_m, 0.75 * carried_m) << "it turns between two nodes of the data, not at once";
}

/// A floe of 2 km is equally near in every direction.
TEST(PlanUnderIce, FindsSmallIceToAnySide) {
  const geo::LocalProjection projection{{-53.0, 69.0}};
  PlanRequest request = support::eastward_request();
  for (int bearing_deg = 0; bearing_deg < 360; bearing_deg += 7) {
    const double bearing = core::degrees_to_radians(bearing_deg);
    const geo::LonLat floe =
        projection.to_lon_lat({11'000.0 * std::sin(bearing), 11'000.0 * std::cos(bearing)});
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, support::steps(-53.5, 0.01, 101),
                                     support::steps(68.8, 0.004, 101)};
    ocean::IceField::Samples samples{
        .grid = grid, .times_s = ocean::Axis{{support::sea_start_s}}, .concentration = {}, .thickness_m = {}};
    for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
      for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
        const bool is_ice = geo::geodesic_between(grid.place(ix, iy), floe).length.value < 1000.0;
        samples.concentration.push_back(is_ice ? 0.95F : 0.0F);
        samples.thickness_m.push_back(1.0F);
      }
    }
    const ocean::Environment environment{.ice = std::make_shared<const ocean::IceField>(std::move(samples))};
    const cost::Sea sea{environment,
                        request,
                        projection,
                        {{-20'000.0, -20'000.0}, {20'000.0, 20'000.0}},
                        core::Metres{1000.0}};

    const auto nearest =
        ice::nearest_ice_within(core::Metres{15'000.0}, *sea.domain().ice(), {0.0, 0.0}, core::Seconds{0.0});

    ASSERT_TRUE(nearest.has_value()) << bearing_deg;
    EXPECT_NEAR(nearest->value, 10'000.0, 700.0) << bearing_deg;
  }
}

/// No plan knows the position error at the end of a list. So ice far beyond the error at the waypoint counts as well.
TEST(PlanUnderIce, TellsOfIceThatIsFarFromItsWaypoints) {
  const ocean::Environment in_the_east{
      .ice = support::ice_from([](geo::LonLat p, double) { return p.lon_deg > -52.25 ? 0.9 : 0.0; }, {0.0},
                               1.0)};

  const Plan plan = planned(in_the_east, support::eastward_request());

  const SurfacingState& start = plan.surfacing->waypoints.front();
  ASSERT_TRUE(start.nearest_ice.has_value());
  const double straight_m = geo::geodesic_between(plan.waypoints.front().place, {-52.25, 69.0}).length.value;
  EXPECT_NEAR(start.nearest_ice->value, straight_m, 0.1 * straight_m);
}

TEST(PlanUnderIce, TellsOfEachLegItsMeanCurrent) {
  const Plan plan = planned_into_ice_with_currents(band_of_ice(), 0.1, 0.1);

  EXPECT_FALSE(plan.waypoints.front().current.has_value());
  ASSERT_TRUE(plan.waypoints.back().current.has_value());
  EXPECT_NEAR(plan.waypoints.back().current->east.value, 0.0, 2e-3);
  EXPECT_NEAR(plan.waypoints.back().current->north.value, 0.1, 2e-3);
  EXPECT_FALSE(planned(band_of_ice(), support::eastward_request()).waypoints.back().current.has_value());
}

TEST(PlanUnderIce, WarnsWhereTheVehicleMayNotSurfaceAtTheDeparture) {
  PlanRequest request = support::eastward_request();
  EXPECT_THAT(messages::sentences(planned(band_of_ice(), request).messages),
              Not(Contains(HasSubstr("the start lies under ice"))));
  request.from = {-53.0, 69.0};  // in the ice

  EXPECT_THAT(messages::sentences(planned(band_of_ice(), request).messages),
              Contains(HasSubstr("the start lies under ice")));
}

TEST(PlanUnderIce, TellsOfAStartAGoalAndViaPointsUnderIceAsDangers) {
  const auto dangers = [](const PlanRequest& request) {
    return messages::dangers_among(planned(band_of_ice(), request).messages);
  };
  PlanRequest request = support::eastward_request();
  EXPECT_THAT(dangers(request), Not(Contains(HasSubstr("under ice")))) << "it only passes below the band";

  PlanRequest starts_below = request;
  starts_below.from = {-53.0, 69.0};
  EXPECT_THAT(dangers(starts_below), Contains(HasSubstr("the start lies under ice")));
  PlanRequest ends_below = request;
  ends_below.to = {-53.0, 69.0};
  EXPECT_THAT(dangers(ends_below), Contains(HasSubstr("the goal lies under ice")));
  request.via = {{-53.4, 69.0}, {-53.0, 69.05}};
  EXPECT_THAT(dangers(request), Contains(HasSubstr("1 of 2 via points lies under ice (number 2)")));
}

/// 32 km of ice without a lead take a day.
TEST(PlanUnderIce, TellsOfALongTimeBelowIceAsADangerUnlessThePilotBoundsIt) {
  const ocean::Environment ice{
      .ice = support::ice_from(
          [](geo::LonLat p, double) { return std::abs(p.lon_deg + 53.0) < 0.4 ? 0.9 : 0.0; }, {0.0}, 1.0)};
  PlanRequest request = support::eastward_request();
  request.from = {-53.6, 69.0};
  request.to = {-52.4, 69.0};

  const Plan long_below = planned(ice, request);
  ASSERT_GT(long_below.surfacing->longest_without.count(), 12.0 * 3600.0);
  EXPECT_THAT(messages::dangers_among(long_below.messages),
              testing::ElementsAre(HasSubstr("without a place to surface")));
  const auto told = std::ranges::find(long_below.messages, "long-below-ice", &messages::Message::code);
  ASSERT_TRUE(told->place);
  EXPECT_LT(told->place->lon_deg, -53.35) << "where the first leg below ice begins";

  request.under_ice.max_time_without_surfacing = core::Seconds{200.0 * 3600.0};
  EXPECT_THAT(messages::dangers_among(planned(ice, request).messages), testing::IsEmpty());
}

/// The ice is stored from four days after the departure on, and held for three days before that.
TEST(PlanUnderIce, MeetsTheIceThatBeginsWhileItLasts) {
  const ocean::Environment later{
      .ice = support::ice_from([](geo::LonLat, double) { return 0.9; }, {96.0, 120.0}, 1.0)};
  PlanRequest request = support::eastward_request();

  const Plan plan = planned(later, request);
  EXPECT_TRUE(plan.surfacing->waypoints.front().may_surface);
  EXPECT_FALSE(plan.surfacing->waypoints.back().may_surface);
  EXPECT_EQ(plan.surfacing->unknown_ice.value, 0.0);

  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * 2.0};
  EXPECT_FALSE(plan_route(later, request, {}, quiet));
}

TEST(PlanUnderIce, TheErrorGrowsWithTheSpeedOfEachLegsDrive) {
  const ocean::Environment ice_everywhere{
      .ice = support::ice_from([](geo::LonLat, double) { return 0.9; }, {0.0}, 1.0)};
  PlanRequest request = support::eastward_request();
  request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  request.energy.objective = energy_objective;
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const cost::Sea sea{ice_everywhere,
                      request,
                      projection,
                      {{-30'000.0, -30'000.0}, {30'000.0, 30'000.0}},
                      core::Metres{1000.0}};
  const std::vector<geo::PlanePoint> route{{-10'000.0, 0.0}, {0.0, 0.0}, {10'000.0, 0.0}};
  const std::vector<vehicle::Drive> drives{vehicle::Drive::thruster, vehicle::Drive::buoyancy};
  cost::Schedule schedule{{core::Seconds{0.0}}, std::vector<core::Seconds>(route.size())};
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const auto time =
        sea.leg_time(route[i], route[i + 1], schedule.arrivals[i], core::Seconds{INFINITY}, drives[i]);
    schedule.arrivals.push_back(schedule.arrivals[i] + time.value());
  }

  const SurfacingPlan plan = cost::plan_surfacings(sea, request, route, schedule, drives);

  double error_m = 0.0;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const double time_s = (schedule.arrivals[i + 1] - schedule.arrivals[i]).count();
    error_m += (0.06 * drive_speed(request.vehicle, drives[i]).value + 0.05) * time_s;
    EXPECT_NEAR(plan.waypoints[i + 1].position_error.value, error_m, 1e-3 * error_m);
    EXPECT_NEAR(plan.waypoints[i + 1].since_surfacing.count(), schedule.arrivals[i + 1].count(), 1.0);
  }
  EXPECT_NEAR(plan.longest_without.count(), schedule.arrivals.back().count(), 1.0);
}

TEST(PlanUnderIce, SurfacesAtIntervalsInOpenWaterAndBeforeAndAfterTheIce) {
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  request.under_ice.surfacing_interval = core::Seconds{3600.0 * 4.0};

  const Plan open = planned({}, request);
  const Plan icy = planned(band_of_ice(), request);

  // 40 km at 0.35 m/s last nearly 32 h; a surfacing comes up to one look of 12 minutes before it is due.
  EXPECT_EQ(open.surfacing->surfacings.size(), 8U);
  for (const PlannedSurfacing& surfacing : open.surfacing->surfacings) {
    EXPECT_LE(surfacing.position_error.value, (0.06 * 0.35 + 0.05) * 3600.0 * 4.0 + 1e-6);
  }
  const auto& planned_ones = icy.surfacing->surfacings;
  ASSERT_GE(planned_ones.size(), 3U);
  EXPECT_THAT(messages::sentences(icy.messages),
              Not(Contains(HasSubstr("the position error exceeds the distance to the ice"))));
  for (const PlannedSurfacing& surfacing : planned_ones)
    EXPECT_FALSE(surfacing.nearest_ice) << "within " << surfacing.position_error.value << " m";
  std::size_t gaps = 0;
  for (std::size_t i = 1; i < planned_ones.size(); ++i) {
    const core::Seconds gap = planned_ones[i].time - planned_ones[i - 1].time;
    if (gap <= *request.under_ice.surfacing_interval) continue;
    ++gaps;
    EXPECT_GT(gap, icy.surfacing->longest_without) << "the way under the ice, and on until it is clear of it";
    const double off_m =
        planned_ones[i].position_error.value + planned_ones[i - 1].position_error.value + 1000.0;
    EXPECT_LT(gap.count(), icy.surfacing->longest_without.count() + off_m / 0.35);
    EXPECT_GT(planned_ones[i].position_error.value, planned_ones[i - 1].position_error.value);
  }
  EXPECT_EQ(gaps, 1U);
}

/// In a lead that is narrower than the position error the middle is the best place.
TEST(PlanUnderIce, SurfacesWithMostRoomWhereItIsNowhereClearOfTheIce) {
  const ocean::Environment lead{
      .ice = support::ice_from(
          [](geo::LonLat p, double) {
            return std::abs(p.lon_deg + 53.0) < 0.4 && std::abs(p.lon_deg + 53.0) > 0.06 ? 0.9 : 0.0;
          },
          {0.0}, 1.0)};
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  request.under_ice.surfacing_interval = core::Seconds{3600.0 * 4.0};

  const Plan plan = planned(lead, request);

  const auto in_the_lead = std::ranges::find_if(
      plan.surfacing->surfacings,
      [](const PlannedSurfacing& surfacing) { return std::abs(surfacing.place.lon_deg + 53.0) < 0.06; });
  ASSERT_NE(in_the_lead, plan.surfacing->surfacings.end());
  EXPECT_NEAR(in_the_lead->place.lon_deg, -53.0, 0.015);
  ASSERT_TRUE(in_the_lead->nearest_ice);
  EXPECT_LT(*in_the_lead->nearest_ice, in_the_lead->position_error);
  EXPECT_THAT(messages::sentences(plan.messages),
              Contains(HasSubstr("the position error exceeds the distance to the ice")));
}

/// Points that were fixed at the ice during refinement are free afterwards. Via points stay fixed.
TEST(PlanUnderIce, VisitsItsPlacesWhereFewWaypointsAndABoundAreAskedFor) {
  const ocean::Environment environment = ice_with_holes(3, 40);
  PlanRequest request = from_hole_to_hole(12.0);
  request.via = {{-52.7, 69.03}};
  for (const int most : {0, 8}) {
    if (most > 0) request.max_waypoints = most;

    const Plan plan = planned(environment, request);

    const auto is_visited = [&](const Waypoint& waypoint) {
      return geo::geodesic_between(waypoint.place, request.via.front()).length.value < 1.0;
    };
    EXPECT_TRUE(std::ranges::any_of(plan.waypoints, is_visited)) << most;
    EXPECT_LE(plan.surfacing->longest_without.count(), 3600.0 * 12.0) << most;
  }
}

TEST(PlanUnderIce, EveryWaypointHasAWayToOpenWater) {
  PlanRequest request = support::eastward_request();
  request.to = {-53.0, 69.0};
  request.via = {{-53.15, 69.0}};
  request.under_ice.escape_plan = true;

  const Plan plan = planned(band_of_ice(), request);

  ASSERT_EQ(plan.surfacing->escapes.size(), plan.waypoints.size());
  const EscapeWay& at_start = plan.surfacing->escapes.front();
  EXPECT_EQ(at_start.time.count(), 0.0);
  EXPECT_EQ(at_start.way.size(), 1U);
  const EscapeWay& from_goal = plan.surfacing->escapes.back();
  // Open water begins about 16.5 km north and 10 to 11 km east and west of the goal.
  EXPECT_NEAR(from_goal.distance.value, 11'000.0, 1500.0);
  EXPECT_NEAR(from_goal.time.count(), from_goal.distance.value / 0.35, 60.0);
  EXPECT_NEAR(geo::geodesic_between(from_goal.way.front(), from_goal.way.back()).length.value,
              from_goal.distance.value, 200.0);
}

TEST(PlanUnderIce, GoingOnIsAnEscapeWhereNothingElseIsInTime) {
  int on_the_way = 0;
  for (const double lon_deg : {-52.95, -52.93, -52.91, -52.89, -52.87, -52.85}) {
    PlanRequest request = support::eastward_request();
    request.via = {{lon_deg, 69.01}};
    const Plan unbounded = planned(band_of_ice(), request);
    // The route just keeps this bound. The vertices of a grid do not lie at the edge of the ice.
    request.under_ice.max_time_without_surfacing = unbounded.surfacing->longest_without + core::Seconds{1.0};
    request.under_ice.escape_plan = true;

    const Plan plan = planned(band_of_ice(), request);

    ASSERT_EQ(plan.surfacing->escapes.size(), plan.waypoints.size());
    for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
      const SurfacingState& state = plan.surfacing->waypoints[i];
      if (state.may_surface) continue;
      ++on_the_way;
      EXPECT_LE((state.since_surfacing + plan.surfacing->escapes[i].time).count(),
                request.under_ice.max_time_without_surfacing->count());
    }
  }
  EXPECT_GT(on_the_way, 3);
}

TEST(PlanUnderIce, TheWayToOpenWaterMustLieWithinWhatIsLeftOfTheBattery) {
  PlanRequest request = support::eastward_request();
  request.to = {-53.0, 69.0};
  request.under_ice.escape_plan = true;
  const Plan plan = planned(band_of_ice(), request);
  const EscapeWay& from_goal = plan.surfacing->escapes.back();
  PlanRequest as_below = request;
  as_below.vehicle.climb_to = plan.surfacing->waypoints.back().least_upper_turn;
  const Plan in_open_water = planned({}, as_below);
  const double power_w = in_open_water.energy->use.total().value / in_open_water.travel_time().count();
  EXPECT_NEAR(from_goal.energy.value, power_w * from_goal.time.count(), 2e-3 * from_goal.energy.value)
      << "over an even sea bed every hour below the ice draws the same";

  // Enough for the route, but not for the escape from its end.
  EnergyUse drawn = plan.energy->use;
  request.vehicle.energy.battery_reserve_share = 0.0;
  request.vehicle.energy.battery = drawn.total() + core::Joules{0.5 * from_goal.energy.value};
  EXPECT_THAT(messages::sentences(planned(band_of_ice(), request).messages),
              Contains(HasSubstr("the escape route from waypoint")));

  request.energy.require_battery = true;
  const auto refused = plan_route(band_of_ice(), request, {}, quiet);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, Reason::energy_exceeded);

  request.vehicle.energy.battery = drawn.total() + core::Joules{1.01 * from_goal.energy.value};
  EXPECT_TRUE(plan_route(band_of_ice(), request, {}, quiet).has_value());
}

TEST(PlanUnderIce, WithoutAnEscapeThereIsNoPlanWhenOneWasAskedFor) {
  PlanRequest request = support::eastward_request();
  request.under_ice.escape_plan = true;
  const ocean::Environment closed{.ice =
                                      support::ice_from([](geo::LonLat, double) { return 0.9; }, {0.0}, 1.0)};

  const auto plan = plan_route(closed, request, {}, quiet);

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().reason, Reason::no_escape);
}

TEST(PlanUnderIce, OpenWaterIsAssumedWithoutData) {
  PlanRequest request = support::eastward_request();
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0};
  request.under_ice.escape_plan = true;

  const Plan plan = planned({}, request);

  EXPECT_EQ(plan.surfacing->longest_without.count(), 0.0);
  EXPECT_EQ(plan.surfacing->escapes.size(), 2U);
  EXPECT_FALSE(planned({}, support::eastward_request()).surfacing);
}

}  // namespace
}  // namespace floeplan::planning::plan_under_ice_test
