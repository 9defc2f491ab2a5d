#include "engine/mission/writing/safe_places.hpp"

#include <gmock/gmock.h>

#include "engine/messages/sentence.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission::safe_places_test {
namespace {

using support::plan_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double open_limit = 0.1;
constexpr geo::LonLat refuge{-53.0, 69.0};
constexpr double day_s = 86400.0;

/// A route of one day. At its end the battery lasts for 302 km more, at its start for the farthest distance
/// allowed.
planning::Plan one_day() {
  planning::Plan plan = plan_of({{-53.1, 69.0}, {-52.5, 69.0}});
  plan.arrival = plan.departure + core::Seconds{day_s};
  plan.waypoints[1].eta = plan.arrival;
  plan.waypoints[1].energy = core::Joules{100e3};
  plan.energy = planning::PlanEnergy{{.hotel = core::Joules{100e3}}, core::Joules{1e6}};
  return plan;
}

ocean::HorizontalGrid grid() {
  return {geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.0}}, ocean::Axis{{68.0, 70.0}}};
}

/// Open water 300 m deep, and `share` of ice at steps the given hours after the departure.
ocean::Environment sea(const planning::Plan& plan, double depth_m,
                       const std::vector<std::pair<double, float>>& ice) {
  ocean::Environment environment;
  const auto depth = static_cast<float>(depth_m);
  environment.bathymetry =
      std::make_shared<const ocean::Bathymetry>(grid(), std::vector<float>{depth, depth, depth, depth});
  std::vector<double> times_s;
  std::vector<float> concentration;
  for (const auto& [hours, share] : ice) {
    times_s.push_back(core::unix_seconds(plan.departure) + 3600.0 * hours);
    concentration.insert(concentration.end(), 4, share);
  }
  environment.ice = std::make_shared<const ocean::IceField>(
      ocean::IceField::Samples{grid(), ocean::Axis{times_s}, concentration, {}});
  return environment;
}

SafePlaceFindings findings(const planning::Plan& plan, const SafePlace& safe) {
  return check_safe_places(plan, *vehicle::find_profile("slocum-g3-200"), open_limit, {safe});
}

auto refused(const char* why) {
  return ElementsAre(
      AllOf(Field(&core::Violation::field, "/safe/0"), Field(&core::Violation::rule, HasSubstr(why))));
}

TEST(SafePlaces, AreOpenWater) {
  const planning::Plan plan = one_day();
  const auto found = findings(plan, {refuge, sea(plan, 300.0, {{0.0, 0.05F}, {48.0, 0.1F}})});

  EXPECT_THAT(found.violations, IsEmpty());
  EXPECT_THAT(found.messages, IsEmpty());
}

TEST(SafePlaces, AreNotOnLandNorInShallows) {
  const planning::Plan plan = one_day();
  ocean::Environment behind_the_coast = sea(plan, 300.0, {{0.0, 0.0F}, {48.0, 0.0F}});
  behind_the_coast.land = {geo::Polygon{{{-53.5, 68.5}, {-52.5, 68.5}, {-52.5, 69.5}, {-53.5, 69.5}}, {}}};

  EXPECT_THAT(findings(plan, {refuge, sea(plan, -50.0, {{0.0, 0.0F}, {48.0, 0.0F}})}).violations,
              refused("on land"));
  EXPECT_THAT(findings(plan, {refuge, behind_the_coast}).violations, refused("on land"));
  EXPECT_THAT(findings(plan, {refuge, sea(plan, 12.0, {{0.0, 0.0F}, {48.0, 0.0F}})}).violations,
              refused("has only 12 m of water, and the vehicle needs 20 m"));
}

TEST(SafePlaces, HaveLittleIceAsLongAsThePlanLasts) {
  const planning::Plan plan = one_day();
  const auto with_ice = [&](const std::vector<std::pair<double, float>>& ice) {
    return findings(plan, {refuge, sea(plan, 300.0, ice)}).violations;
  };

  EXPECT_THAT(with_ice({{0.0, 0.9F}, {48.0, 0.9F}}), refused("90 % of ice"));
  EXPECT_THAT(with_ice({{0.0, 0.0F}, {12.0, 0.5F}, {24.0, 0.0F}}), refused("50 % of ice"));
  EXPECT_THAT(with_ice({{-48.0, 0.0F}, {-24.0, 0.8F}}), refused("80 % of ice")) << "the last step holds";
  EXPECT_THAT(with_ice({{-80.0, 0.0F}, {-60.0, 0.7F}}), refused("70 % of ice")) << "as long as it holds";
  EXPECT_THAT(with_ice({{-24.0, 0.8F}, {0.0, 0.0F}, {24.0, 0.0F}, {48.0, 0.8F}}), IsEmpty());
}

TEST(SafePlaces, LieWithinTheRestOfTheBattery) {
  const planning::Plan plan = one_day();  // 1.16 W at 0.35 m/s: 302 km from the start
  ocean::Environment nothing;

  EXPECT_THAT(findings(plan, {{-53.1, 71.6}, nothing}).violations, IsEmpty()) << "290 km";
  EXPECT_THAT(findings(plan, {{-53.1, 72.0}, nothing}).violations, refused("335 km from the plan"));
}

TEST(SafePlaces, OfWhichNothingIsKnownAreNamed) {
  const planning::Plan plan = one_day();
  ocean::Environment no_ice = sea(plan, 300.0, {{0.0, 0.0F}, {48.0, 0.0F}});
  no_ice.ice = nullptr;

  EXPECT_THAT(messages::sentences(findings(plan, {refuge, {}}).messages),
              ElementsAre(HasSubstr("the sea bed and the ice")));
  EXPECT_THAT(messages::sentences(findings(plan, {refuge, no_ice}).messages),
              ElementsAre(HasSubstr("data on the ice at")));
  EXPECT_THAT(messages::sentences(
                  findings(plan, {refuge, sea(plan, 300.0, {{-200.0, 0.0F}, {-100.0, 0.0F}})}).messages),
              ElementsAre(HasSubstr("data on the ice at")))
      << "older than ice holds";
  EXPECT_THAT(messages::sentences(
                  findings(plan, {refuge, sea(plan, 300.0, {{-240.0, 0.0F}, {240.0, 0.0F}})}).messages),
              ElementsAre(HasSubstr("data on the ice at")))
      << "in a long gap";
}

TEST(SafePlaces, LieInNoAreaThatIsForbiddenThen) {
  const planning::Plan plan = one_day();
  ocean::Environment open = sea(plan, 300.0, {{-1.0, 0.0F}, {30.0, 0.0F}});
  ocean::Zone zone;
  zone.name = "range";
  zone.area = {.outer = {{-53.1, 68.9}, {-52.9, 68.9}, {-52.9, 69.1}, {-53.1, 69.1}}, .holes = {}};
  open.zones = {zone};
  EXPECT_THAT(findings(plan, {refuge, open}).violations, refused("no-go area range"));

  open.zones.front().until = plan.departure - core::Seconds{60.0};
  EXPECT_THAT(findings(plan, {refuge, open}).violations, IsEmpty()) << "over when the vehicle leaves";
  open.zones = {zone};
  open.zones.front().kind = ocean::ZoneKind::stay_in;
  EXPECT_THAT(findings(plan, {refuge, open}).violations, IsEmpty());
}

TEST(SafePlaces, AreNotBelowIcebergsAndSayWhichAreNear) {
  const planning::Plan plan = one_day();
  ocean::Environment open = sea(plan, 300.0, {{-1.0, 0.0F}, {30.0, 0.0F}});
  ocean::Iceberg berg;
  berg.id = "B1";
  berg.place = refuge;
  berg.observed = plan.departure;
  berg.length = core::Metres{400.0};
  open.icebergs = {berg};
  EXPECT_THAT(findings(plan, {refuge, open}).violations, refused("iceberg B1 was last seen at"));

  open.icebergs.front().place.lat_deg += 0.02;
  const SafePlaceFindings near = findings(plan, {refuge, open});
  EXPECT_THAT(near.violations, IsEmpty());
  EXPECT_THAT(messages::sentences(near.messages),
              ElementsAre(HasSubstr("iceberg B1 was seen within 2.2 km of the safe place")));
}

}  // namespace
}  // namespace floeplan::mission::safe_places_test
