#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/documents/plan_document.hpp"
#include "api/codec/inputs/plan_inputs.hpp"

namespace floeplan::codec::under_ice_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

json inputs_with(const json& under_ice) {
  return {{"from", {-53.2, 69.2}},
          {"to", {-51.6, 69.2}},
          {"depart", "2026-11-22T06:00:00Z"},
          {"under_ice", under_ice}};
}

TEST(UnderIceInputs, AreReadWithTheirUnits) {
  const auto inputs = parse_plan_inputs(inputs_with({{"max_concentration_to_surface", 0.3},
                                                     {"margin_below_ice_m", 15},
                                                     {"draft_if_unknown_m", 25},
                                                     {"max_time_without_surfacing_s", 21600},
                                                     {"surfacing_interval_s", 7200},
                                                     {"escape_plan", true},
                                                     {"dead_reckoning_share", 0.1},
                                                     {"current_uncertainty_m_s", 0.2}}));

  ASSERT_TRUE(inputs);
  const planning::UnderIceRules& rules = inputs->request.under_ice;
  EXPECT_EQ(rules.max_concentration_to_surface, 0.3);
  EXPECT_EQ(rules.margin_below_ice.value, 15.0);
  EXPECT_EQ(rules.draft_if_unknown.value, 25.0);
  EXPECT_EQ(rules.max_time_without_surfacing, core::Seconds{21600.0});
  EXPECT_EQ(rules.surfacing_interval, core::Seconds{7200.0});
  EXPECT_TRUE(rules.escape_plan);
  EXPECT_EQ(rules.dead_reckoning_share, 0.1);
  EXPECT_EQ(rules.current_uncertainty.value, 0.2);
}

TEST(UnderIceInputs, ComeBackTheSameFromTheirOwnTextAndShowEveryDefault) {
  const auto inputs = parse_plan_inputs(inputs_with(json::object()));
  ASSERT_TRUE(inputs);
  const json written = to_json(*inputs);

  EXPECT_EQ(written.at("under_ice").at("max_concentration_to_surface"), 0.1);
  EXPECT_TRUE(written.at("under_ice").at("max_time_without_surfacing_s").is_null());
  EXPECT_EQ(written.at("ice"), "newest");
  EXPECT_EQ(to_json(parse_plan_inputs(written).value()), written);
}

TEST(UnderIceInputs, AreRefusedWithThePlaceOfEveryFault) {
  const auto inputs = parse_plan_inputs(inputs_with({{"max_concentration_to_surface", 10},
                                                     {"max_time_without_surfacing_s", "6 h"},
                                                     {"escape_plan", 1},
                                                     {"max_time_without_surfacing", 3600}}));

  ASSERT_FALSE(inputs);
  std::vector<std::string> fields;
  for (const core::Violation& violation : inputs.error()) fields.push_back(violation.field);
  EXPECT_THAT(fields, ElementsAre("/under_ice/max_concentration_to_surface",
                                  "/under_ice/max_time_without_surfacing_s", "/under_ice/escape_plan",
                                  "/under_ice/max_time_without_surfacing"));
  EXPECT_THAT(inputs.error().front().rule, HasSubstr("from 0.0 to 1.0"));

  const auto not_an_object = parse_plan_inputs(inputs_with("strict"));
  ASSERT_FALSE(not_an_object);
  EXPECT_EQ(not_an_object.error().front().field, "/under_ice");
}

planning::Plan plan_with_surfacings() {
  planning::Plan plan;
  plan.departure = core::from_unix_seconds(1'800'000'000.0);
  plan.arrival = plan.departure + core::Seconds{7200.0};
  plan.waypoints.resize(2);
  plan.waypoints[0].place = {-53.0, 69.0};
  plan.waypoints[0].eta = plan.departure;
  plan.waypoints[1].place = {-52.9, 69.0};
  plan.waypoints[1].eta = plan.arrival;
  plan.waypoints[1].current = geo::VelocityEn{{0.12}, {-0.03}};
  plan.surfacing = planning::SurfacingPlan{
      .longest_without = core::Seconds{5400.0},
      .unknown_ice = {1200.0},
      .waypoints = {{},
                    {.may_surface = false,
                     .since_surfacing = core::Seconds{5400.0},
                     .position_error = {383.4},
                     .least_upper_turn = {18.0},
                     .leg_upper_turn = core::Metres{21.5},
                     .ice_free_before = core::Metres{0.0},
                     .error_without_fix = core::Metres{511.2},
                     .nearest_ice = core::Metres{120.5}}},
      .reckoned = {},
      .surfacings = {{.place = {-52.95, 69.0},
                      .time = plan.departure + core::Seconds{1800.0},
                      .position_error = {127.8}}},
      .escapes = {{.way = {{-53.0, 69.0}},
                   .course_deg = std::nullopt,
                   .distance = {0.0},
                   .time = core::Seconds{0.0}},
                  {.way = {{-52.9, 69.0}, {-52.95, 69.0}},
                   .course_deg = 270.0,
                   .distance = {2000.0},
                   .time = core::Seconds{5714.0},
                   .energy = {12345.0}}},
      .ice_beside = {},
      .below_ice = std::vector<planning::StretchBelowIce>{{.waypoint = 1,
                                                           .from = {-52.96, 69.0},
                                                           .to = {-52.95, 69.0},
                                                           .enters = plan.departure + core::Seconds{1800.0},
                                                           .time = core::Seconds{1100.0},
                                                           .length = {398.5}},
                                                          {.waypoint = 1,
                                                           .from = {-52.92, 69.0},
                                                           .to = {-52.9, 69.0},
                                                           .enters = plan.departure + core::Seconds{5400.0},
                                                           .time = core::Seconds{1800.0},
                                                           .length = {797.0}}}};
  return plan;
}

TEST(PlanDocument, SaysOfEachWaypointWhatIceMeansThere) {
  const json document = plan_document(plan_with_surfacings(), "p1", "");

  const json& last = document.at("waypoints").at(1);
  EXPECT_EQ(last.at("may_surface"), false);
  EXPECT_EQ(last.at("since_last_surfacing_s"), 5400.0);
  EXPECT_EQ(last.at("position_error_m"), 383.4);
  EXPECT_EQ(last.at("least_upper_turn_m"), 18.0);
  EXPECT_EQ(last.at("leg_upper_turn_m"), 21.5);
  EXPECT_EQ(last.at("ice_free_before_m"), 0.0);
  EXPECT_EQ(last.at("error_without_fix_m"), 511.2);
  EXPECT_EQ(last.at("nearest_ice_m"), 120.5);
  EXPECT_EQ(last.at("current_east_m_s"), 0.12);
  EXPECT_EQ(last.at("current_north_m_s"), -0.03);
  EXPECT_TRUE(document.at("waypoints").at(0).at("current_east_m_s").is_null());
  EXPECT_TRUE(document.at("waypoints").at(0).at("nearest_ice_m").is_null());
  EXPECT_TRUE(document.at("waypoints").at(0).at("leg_upper_turn_m").is_null());
  EXPECT_EQ(document.at("surfacing").at("planned").at(0).at("time"), "2027-01-15T08:30:00Z");
  EXPECT_EQ(document.at("surfacing").at("below_ice_m"), 1195.5);
  EXPECT_EQ(document.at("surfacing").at("below_ice_s"), 2900.0);
  EXPECT_EQ(document.at("surfacing").at("below_ice").at(0).at("enters"), "2027-01-15T08:30:00Z");
  const json& escape = document.at("surfacing").at("escapes").at(1);
  EXPECT_EQ(escape.at("to"), json::array({-52.95, 69.0}));
  EXPECT_EQ(escape.at("course_deg"), 270.0);
  EXPECT_EQ(escape.at("distance_m"), 2000.0);
  EXPECT_EQ(escape.at("time_s"), 5714.0);
  EXPECT_EQ(escape.at("energy_j"), 12345.0);
}

TEST(PlanDocument, WithSurfacingsIsReadBackTheSame) {
  const json document = plan_document(plan_with_surfacings(), "p1", "");

  EXPECT_EQ(plan_document(parse_plan_document(document), "p1", ""), document);
}

TEST(PlanDocument, FromBeforeLegsToldHowDeepTheirDivesTurnIsStillRead) {
  json document = plan_document(plan_with_surfacings(), "p1", "");
  for (json& waypoint : document.at("waypoints"))
    for (const char* later : {"leg_upper_turn_m", "ice_free_before_m", "error_without_fix_m", "nearest_ice_m",
                              "current_east_m_s", "current_north_m_s"})
      waypoint.erase(later);
  for (const char* later : {"below_ice_m", "below_ice_s", "below_ice"}) document.at("surfacing").erase(later);

  const planning::Plan plan = parse_plan_document(document);

  ASSERT_EQ(plan.surfacing->waypoints.size(), 2U);
  EXPECT_FALSE(plan.surfacing->waypoints[1].leg_upper_turn.has_value());
  EXPECT_FALSE(plan.surfacing->waypoints[1].ice_free_before.has_value());
  EXPECT_TRUE(plan_document(plan, "p1", "").at("surfacing").at("below_ice_m").is_null())
      << "not known, not 0";
  EXPECT_EQ(plan.surfacing->waypoints[1].least_upper_turn, core::Metres{18.0});
}

TEST(PlanDocument, FromBeforeThereWasIceIsStillRead) {
  planning::Plan plan = plan_with_surfacings();
  plan.surfacing.reset();
  json document = plan_document(plan, "p1", "");
  EXPECT_TRUE(document.at("waypoints").at(0).at("may_surface").is_null());
  document.erase("surfacing");
  for (json& waypoint : document.at("waypoints")) waypoint.erase("may_surface");

  EXPECT_FALSE(parse_plan_document(document).surfacing);
}

}  // namespace
}  // namespace floeplan::codec::under_ice_test
