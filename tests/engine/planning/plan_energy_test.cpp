#include <gmock/gmock.h>

#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_energy_test {
namespace {

using support::eastward_request;
using testing::Contains;
using testing::HasSubstr;

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

TEST(PlanEnergy, IsCountedLegByLeg) {
  const auto found = plan({}, eastward_request());

  ASSERT_TRUE(found && found->energy);
  const EnergyUse& use = found->energy->use;
  EXPECT_NEAR(use.hotel.value, 1.16 * found->travel_time().count(), 1e-6 * use.hotel.value);
  EXPECT_GT(use.pump.value, 0.0);
  EXPECT_GT(use.inflections, 10.0);
  EXPECT_EQ(found->waypoints.front().energy->value, 0.0);
  EXPECT_EQ(found->waypoints.back().energy, use.total());
  EXPECT_EQ(found->waypoints.back().drive, vehicle::Drive::buoyancy);
  EXPECT_EQ(found->waypoints.back().speed_through_water->value, 0.35);
  EXPECT_FALSE(found->waypoints.front().drive.has_value());
}

TEST(PlanEnergy, WarnsWhenTheBatteryDoesNotLast) {
  PlanRequest request = eastward_request();
  request.vehicle.energy.battery = {2e5};

  const auto found = plan({}, request);

  ASSERT_TRUE(found.has_value());
  EXPECT_THAT(messages::sentences(found->messages),
              Contains(HasSubstr("the battery has only 0.18 MJ above its reserve")));
}

TEST(PlanEnergy, RefusesAPlanBeyondTheBatteryWhereItIsRequired) {
  PlanRequest request = eastward_request();
  request.via = {{-53.0, 69.1}};
  request.vehicle.energy.battery_start_share = 0.115;
  request.energy.require_battery = true;

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::energy_exceeded);
  EXPECT_THAT(found.error().explanation(), HasSubstr("MJ are missing"));

  request.vehicle.energy.battery_start_share = 1.0;
  EXPECT_TRUE(plan({}, request).has_value());
}

TEST(PlanEnergy, OfAThrusterIsSpentWhereTimeIsAllThatCounts) {
  PlanRequest request = eastward_request();
  const auto slow = plan({}, request);
  request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();

  const auto fast = plan({}, request);
  request.energy.thruster = ThrusterUse::off;
  const auto off = plan({}, request);

  ASSERT_TRUE(slow && fast && off);
  EXPECT_NEAR(slow->travel_time() / fast->travel_time(), (1852.0 / 3600.0) / 0.35, 1e-3);
  EXPECT_GT(fast->energy->use.thruster.value, 0.0);
  EXPECT_EQ(fast->waypoints.back().drive, vehicle::Drive::thruster);
  EXPECT_EQ(off->arrival, slow->arrival);
  EXPECT_EQ(off->energy->use.thruster.value, 0.0);
}

}  // namespace
}  // namespace floeplan::planning::plan_energy_test
