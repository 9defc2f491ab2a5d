#include "engine/planning/diagnosis/paired_changes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/plan_route.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::diagnosis::paired_changes_test {
namespace {

using support::bathymetry_from;
using support::eastward_request;

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

ocean::Zone area_across(std::string name, double lon) {
  return {.name = std::move(name),
          .kind = ocean::ZoneKind::no_go,
          .area = {.outer = {{lon, 67.6}, {lon + 0.02, 67.6}, {lon + 0.02, 70.4}, {lon, 70.4}}, .holes = {}},
          .from = {},
          .until = {}};
}

/// 150 m of water over a sill from south to north, deep water on both sides.
ocean::Environment sea_with_a_sill() {
  return {.bathymetry = bathymetry_from(
              [](geo::LonLat p) { return std::abs(p.lon_deg + 53.0) < 0.1 ? 150.0 : 300.0; })};
}

TEST(PairedChanges, NameAnAreaWithTheDepthOfTheSillBehindIt) {
  const ocean::Environment environment = sea_with_a_sill();
  PlanRequest request = eastward_request();
  request.vehicle.minimum_working_depth = core::Metres{180.0};
  request.zones = {area_across("fishery", -52.7)};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  ASSERT_EQ(found.error().changes.size(), 1U);
  const Change& both = found.error().changes.front();
  ASSERT_EQ(both.with.size(), 1U);
  const bool area_first = both.input == "areas/features/0";
  const Change& area = area_first ? both : both.with.front();
  const Change& depth = area_first ? both.with.front() : both;
  EXPECT_EQ(area.input, "areas/features/0");
  ASSERT_EQ(depth.input, "vehicle/minimum_working_depth_m");
  EXPECT_GT(std::get<double>(depth.to), 140.0) << "no less than is needed beside the other change";
  EXPECT_NE(both.text.find("leave out the area \"fishery\""), std::string::npos);
  EXPECT_NE(both.text.find("let the vehicle work in water of"), std::string::npos);
  PlanRequest changed = request;
  changed.zones.clear();
  EXPECT_FALSE(plan(environment, changed).has_value()) << "none of them helps alone";
  changed.vehicle.minimum_working_depth = {std::get<double>(depth.to)};
  EXPECT_TRUE(plan(environment, changed).has_value());
}

TEST(PairedChanges, NameADepthWithTheBatteryThatTheWayNeeds) {
  const ocean::Environment environment = sea_with_a_sill();
  PlanRequest request = eastward_request();
  request.vehicle.minimum_working_depth = core::Metres{180.0};
  request.vehicle.energy.battery = core::Joules{0.2e6};
  request.energy.require_battery = true;

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  ASSERT_EQ(found.error().changes.size(), 1U);
  const Change& both = found.error().changes.front();
  ASSERT_EQ(both.with.size(), 1U);
  EXPECT_EQ(both.input, "battery_j");
  EXPECT_EQ(both.with.front().input, "vehicle/minimum_working_depth_m");
  PlanRequest changed = request;
  changed.vehicle.energy.battery = {std::get<double>(both.to)};
  changed.vehicle.minimum_working_depth = {std::get<double>(both.with.front().to)};
  EXPECT_TRUE(plan(environment, changed).has_value());
}

TEST(PairedChanges, AreNotLookedForWhereOneChangeHelps) {
  PlanRequest request = eastward_request();
  request.vehicle.minimum_working_depth = core::Metres{180.0};

  const auto found = plan(sea_with_a_sill(), request);

  ASSERT_FALSE(found.has_value());
  ASSERT_FALSE(found.error().changes.empty());
  for (const Change& change : found.error().changes) EXPECT_TRUE(change.with.empty());
}

TEST(PairedChanges, AreNoneWhereAThirdThingStandsInTheWay) {
  ocean::Environment environment = sea_with_a_sill();
  environment.bathymetry = bathymetry_from([](geo::LonLat p) {
    if (std::abs(p.lon_deg + 53.25) < 0.05) return -10.0;
    return std::abs(p.lon_deg + 53.0) < 0.1 ? 150.0 : 300.0;
  });
  PlanRequest request = eastward_request();
  request.vehicle.minimum_working_depth = core::Metres{180.0};
  request.zones = {area_across("fishery", -52.7)};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  for (const Change& change : found.error().changes) ADD_FAILURE() << change.text;
}

}  // namespace
}  // namespace floeplan::planning::diagnosis::paired_changes_test
