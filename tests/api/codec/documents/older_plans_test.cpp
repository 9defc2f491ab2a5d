#include "api/codec/documents/older_plans.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/documents/plan_document.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec::older_plans_test {
namespace {

using nlohmann::json;

planning::Plan plan_below_ice() {
  planning::Plan plan;
  plan.vehicle = "slocum-g3-200";
  plan.departure = core::parse_iso8601("2026-11-20T06:00:00Z").value();
  plan.arrival = plan.departure + core::Seconds{7200.0};
  plan.waypoints = {{.place = {-53.25, 69.2}, .eta = plan.departure},
                    {.place = {-53.0, 69.125}, .eta = plan.arrival}};
  plan.surfacing = planning::SurfacingPlan{
      .longest_without = core::Seconds{7200.0},
      .unknown_ice = {0.0},
      .waypoints = {{.may_surface = true}, {.may_surface = false}},
      .surfacings = {{.place = {-53.0, 69.125}, .time = plan.arrival, .position_error = {100.0}}},
      .escapes = {{.way = {{-53.25, 69.2}}, .distance = {0.0}, .time = core::Seconds{0.0}}}};
  return plan;
}

TEST(OlderPlans, OfThisVersionLackNothing) {
  const json document = plan_document(plan_below_ice(), "p1", "");

  EXPECT_EQ(with_later_members(document), document);
}

TEST(OlderPlans, KeepWhatTheyHave) {
  json document = plan_document(plan_below_ice(), "p1", "");
  document.at("waypoints").at(1)["energy_j"] = 12.5;
  document.at("waypoints").at(1).erase("wait_s");

  const json completed = with_later_members(document);

  EXPECT_EQ(completed.at("waypoints").at(1).at("energy_j"), 12.5);
  EXPECT_EQ(completed.at("waypoints").at(1).at("wait_s"), 0.0);
}

/// Law: a stored plan is read without any of the members that later versions added.
void erase_each(json& part, const std::vector<const char*>& later, const json& document) {
  for (const char* name : later) {
    const json kept = part.at(name);
    part.erase(name);
    EXPECT_NO_THROW((void)parse_plan_document(document)) << name;
    part[name] = kept;
  }
}

TEST(OlderPlans, AreReadWithoutAnyMemberThatCameLater) {
  json document = plan_document(plan_below_ice(), "p1", "");

  erase_each(document,
             {"energy", "encounter_trade", "iceberg_encounters", "leg_trade", "passed_under", "refinement",
              "via_order"},
             document);
  erase_each(document.at("search"), {"cut_short", "possible_gain_s"}, document);
  erase_each(document.at("waypoints").at(1),
             {"current_east_m_s", "current_north_m_s", "energy_j", "error_without_fix_m", "ice_free_before_m",
              "iceberg_encounters", "leg_upper_turn_m", "nearest_ice_m", "propulsion",
              "speed_through_water_m_s", "wait_s"},
             document);
  erase_each(document.at("surfacing").at("planned").at(0), {"nearest_ice_m"}, document);
  erase_each(document.at("surfacing").at("escapes").at(0), {"energy_j", "propulsion"}, document);
}

}  // namespace
}  // namespace floeplan::codec::older_plans_test
