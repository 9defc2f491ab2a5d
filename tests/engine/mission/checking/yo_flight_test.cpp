#include "engine/mission/checking/yo_flight.hpp"

#include <gmock/gmock.h>

#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::mission::yo_flight_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

/// The current runs with the vehicle near the surface, and against it far below.
ocean::Environment sheared_sea() { return {.currents = support::sheared_currents(200)}; }

planning::PlanRequest request_of(const char* vehicle) {
  planning::PlanRequest request = support::eastward_request();
  request.vehicle = *vehicle::find_profile(vehicle);
  request.method = planning::Method::direct;
  return request;
}

planning::Plan planned(const ocean::Environment& sea, const planning::PlanRequest& request) {
  return planning::plan_route(sea, request, {}, {}).value();
}

/// The plan as if dives on its first leg may turn no higher than this because of ice.
planning::Plan below_ice(planning::Plan plan, double upper_turn_m) {
  plan.surfacing.emplace();
  plan.surfacing->waypoints.resize(plan.waypoints.size());
  plan.surfacing->waypoints[1].leg_upper_turn = core::Metres{upper_turn_m};
  return plan;
}

YoFlight flight_of(const ocean::Environment& sea, const planning::PlanRequest& request,
                   const planning::Plan& plan) {
  std::vector<geo::LonLat> route;
  for (const planning::Waypoint& waypoint : plan.waypoints) route.push_back(waypoint.place);
  return fly_by_yo(sea, route, request, plan);
}

TEST(YoFlight, IsThatOfThePlanInOpenWater) {
  planning::PlanRequest request = request_of("slocum-g3-200");
  request.vehicle.dive_depth = core::Metres{180.0};
  const planning::Plan plan = planned(sheared_sea(), request);

  EXPECT_FALSE(flies_otherwise(plan, request.vehicle));
  const YoFlight flight = flight_of(sheared_sea(), request, plan);
  EXPECT_THAT(flight.violations, IsEmpty());
  EXPECT_THAT(flight.messages, IsEmpty());
}

TEST(YoFlight, IsRefusedWhereTheCurrentAtItsDepthsStopsTheVehicle) {
  planning::PlanRequest request = request_of("slocum-g3-200");
  request.vehicle.speed_through_water = {0.15};
  const planning::Plan plan = below_ice(planned(sheared_sea(), request), 90.0);

  EXPECT_TRUE(flies_otherwise(plan, request.vehicle));
  EXPECT_THAT(
      flight_of(sheared_sea(), request, plan).violations,
      ElementsAre(Field(&core::Violation::rule,
                        AllOf(HasSubstr("turns between 90 m and 180 m on the whole route"),
                              HasSubstr("on the whole route. Before waypoint 1, at "), HasSubstr("the current is too strong"),
                              HasSubstr("plan again with an upper turn at 90 m (--climb-to 90)")))));
}

TEST(YoFlight, TellsTheTimesAndTheDrawThatAreNotThePlans) {
  const planning::PlanRequest request = request_of("slocum-g3-200");
  const planning::Plan plan = below_ice(planned(sheared_sea(), request), 90.0);
  planning::PlanRequest deep = request;
  deep.vehicle.climb_to = core::Metres{90.0};
  deep.vehicle.dive_depth = core::Metres{180.0};

  const YoFlight flight = flight_of(sheared_sea(), request, plan);

  const planning::Plan flown = planned(sheared_sea(), deep);
  EXPECT_GT(flown.travel_time(), 1.3 * plan.travel_time()) << "a sea in which it matters";
  EXPECT_THAT(flight.violations, IsEmpty());
  EXPECT_THAT(messages::sentences(flight.messages),
              ElementsAre(AllOf(HasSubstr(" min later than planned"), HasSubstr("--climb-to 90"))));
}

TEST(YoFlight, IsRefusedWhereItEmptiesTheBatteryThatCarriesThePlan) {
  planning::PlanRequest request = request_of("slocum-g3-200");
  const planning::Plan alone = planned(sheared_sea(), request);
  request.vehicle.energy.battery = 1.2 * alone.energy->use.total();
  request.vehicle.energy.battery_start_share = 1.0;
  request.vehicle.energy.battery_reserve_share = 0.0;
  const planning::Plan plan = below_ice(planned(sheared_sea(), request), 150.0);

  EXPECT_THAT(flight_of(sheared_sea(), request, plan).violations,
              ElementsAre(Field(&core::Violation::rule, HasSubstr("but the battery has only"))));
}

TEST(YoFlight, LeavesTheThrusterOffWherePlansRunItOnSomeLegs) {
  planning::PlanRequest request = request_of("slocum-g3-200-thruster");
  request.energy.thruster = planning::ThrusterUse::on;
  const ocean::Environment sea{.currents = support::currents_from(
                                   [](geo::LonLat, double) { return geo::VelocityEn{{-0.4}, {0.0}}; }, 400)};
  request.max_leg = core::Metres{25'000.0};
  planning::Plan plan = planned(sea, request);
  ASSERT_EQ(plan.waypoints.size(), 3U);
  plan.waypoints[1].drive = vehicle::Drive::buoyancy;

  EXPECT_TRUE(flies_otherwise(plan, request.vehicle));
  const YoFlight flight = flight_of(sea, request, plan);

  ASSERT_FALSE(flight.violations.empty());
  EXPECT_THAT(flight.violations.front().rule,
              AllOf(HasSubstr("leaves the thruster off"), HasSubstr("too strong"),
                    HasSubstr("(--thruster on) or on none (--thruster off)")));
}

}  // namespace
}  // namespace floeplan::mission::yo_flight_test
