#include "engine/mission/writing/hold_lists.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/mission/document/hold_order.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/goto_lists.hpp"
#include "engine/mission/writing/mission_set.hpp"
#include "tests/engine/mission/random_plan.hpp"
#include "tests/support/property.hpp"

namespace floeplan::mission::hold_lists_test {
namespace {

using support::for_each_seed;
using support::uniform;
using testing::Contains;
using testing::HasSubstr;

constexpr core::Seconds hour{3600.0};
const std::vector<geo::LonLat> through_a_strait{{-53.2, 69.2}, {-53.0, 69.2}, {-52.8, 69.2}};

planning::Plan holding_plan(core::Seconds wait, geo::VelocityEn current) {
  planning::Plan plan = support::plan_of(through_a_strait);
  plan.waypoints[1].wait = wait;
  plan.waypoints[2].eta += wait;
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) plan.waypoints[i].current = current;
  return plan;
}

double turned_deg(geo::Bearing a, geo::Bearing b) {
  return std::abs(core::radians_to_degrees(
      std::asin(std::clamp(a.east() * b.north() - a.north() * b.east(), -1.0, 1.0))));
}

std::vector<Document> read(const MissionFiles& files) {
  std::vector<Document> documents;
  for (const MissionFile& file : files.files) documents.push_back(read_document(file.name, file.text));
  return documents;
}

TEST(HoldLists, KeepTheVehicleAcrossTheCurrentWithinTheCircle) {
  for_each_seed(12, [](std::mt19937_64& rng) {
    const geo::Bearing set = geo::Bearing::degrees(uniform(rng, 0.0, 360.0));
    const double strength = uniform(rng, 0.02, 0.28);
    const planning::Plan plan =
        holding_plan(uniform(rng, 2.5, 12.0) * hour, {{strength * set.east()}, {strength * set.north()}});
    GotoListOptions options;
    options.holds.radius = {uniform(rng, 300.0, 1500.0)};

    const auto lists = write_goto_lists(plan, options);

    ASSERT_TRUE(lists.has_value());
    ASSERT_EQ(lists->files.size(), 3U);
    const Document read = read_document(lists->files[1].name, lists->files[1].text);
    EXPECT_EQ(read.verdict(), Verdict::ok);
    const auto hold = hold_order(read);
    ASSERT_TRUE(hold.has_value());
    EXPECT_NEAR(turned_deg(hold->axis, set), 90.0, 0.5);
    EXPECT_LT(geo::geodesic_between(hold->place, plan.waypoints[1].place).length.value, 1.0);
    for (const WaypointRow& row : read.waypoints)
      EXPECT_LE(geo::geodesic_between(row.place, plan.waypoints[1].place).length,
                options.holds.radius + core::Metres{1.0});
    EXPECT_EQ(hold->planned,
              (HoldTimes{plan.waypoints[1].eta,
                         plan.waypoints[1].eta + core::Seconds{std::round(plan.waypoints[1].wait.count())}}));
  });
}

TEST(HoldLists, TakeAboutAsLongAsTheWait) {
  for_each_seed(30, [](std::mt19937_64& rng) {
    const double strength = uniform(rng, 0.0, 0.28);
    HoldFlight flight{.wait = uniform(rng, 2.0, 12.0) * hour,
                      .circle = {500.0},
                      .speed = {0.35},
                      .vertical = {0.17},
                      .band = {{5.0}, {uniform(rng, 30.0, 150.0)}},
                      .between_surfacings = 3.0 * hour,
                      .currents = {{{strength}, {0.0}}}};

    const auto legs = hold_legs(flight);

    ASSERT_TRUE(legs.has_value());
    ASSERT_GE(legs->legs, 3);
    EXPECT_NEAR(legs->expected / flight.wait, 1.0, 0.05);
    EXPECT_EQ(hold_time(flight, *legs), legs->expected);
  });
}

TEST(HoldLists, StandBetweenTheListsBeforeAndAfter) {
  planning::Plan plan = holding_plan(4.0 * hour, {{0.1}, {0.05}});
  GotoListOptions options;

  const auto written = write_goto_lists(plan, options);

  ASSERT_TRUE(written.has_value());
  const std::vector<Document> lists = read(*written);
  ASSERT_EQ(lists.size(), 3U);
  EXPECT_FALSE(hold_order(lists[0]) || hold_order(lists[2]));
  EXPECT_EQ(lists[0].waypoints.size(), 1U);
  EXPECT_EQ(lists[2].waypoints.size(), 1U);
  EXPECT_EQ(written->files[1].name, "goto_l11.ma");
  EXPECT_THAT(written->files[1].text, HasSubstr("hold at waypoint 1 of 2"));
  EXPECT_THAT(messages::sentences(written->messages),
              Contains(HasSubstr("goto_l11.ma holds station at waypoint 1")));
  EXPECT_EQ(write_goto_lists(plan, options)->files, written->files);
}

TEST(HoldLists, BeginThePlanWhereItHoldsAtItsStart) {
  planning::Plan plan = support::plan_of(through_a_strait);
  plan.waypoints[0].wait = 4.0 * hour;

  const auto written = write_goto_lists(plan, {});

  ASSERT_TRUE(written.has_value());
  const std::vector<Document> lists = read(*written);
  ASSERT_EQ(lists.size(), 2U);
  ASSERT_TRUE(hold_order(lists[0]).has_value());
  EXPECT_LT(geo::geodesic_between(hold_order(lists[0])->place, through_a_strait[0]).length.value, 1.0);
  EXPECT_EQ(lists[1].waypoints.size(), 2U);
  EXPECT_THAT(messages::sentences(written->messages),
              testing::Contains(testing::HasSubstr("holds station at waypoint S with")));
}

TEST(HoldLists, GoRoundForEverWhereCountedLegsWouldEndHoursOff) {
  const auto written = write_goto_lists(holding_plan(60.0 * hour, {{0.1}, {0.0}}), {});

  ASSERT_TRUE(written.has_value());
  const auto hold = hold_order(read(*written)[1]);
  ASSERT_TRUE(hold.has_value());
  EXPECT_EQ(hold->legs, -1);
  EXPECT_THAT(messages::sentences(written->messages), Contains(HasSubstr("without end")));
}

TEST(HoldLists, LeaveAShortHoldToThePilot) {
  const auto written = write_goto_lists(holding_plan(0.4 * hour, {{0.1}, {0.0}}), {});

  ASSERT_TRUE(written.has_value());
  EXPECT_EQ(written->files.size(), 2U) << "the list ends where the vehicle holds";
  EXPECT_THAT(messages::sentences(written->messages), Contains(HasSubstr("shorter than a list of two rows")));
  EXPECT_EQ(write_goto_lists(holding_plan(core::Seconds{300.0}, {}), {})->files.size(), 1U);
}

TEST(HoldLists, SayWhereTheVehicleMayNotComeUpToHold) {
  planning::Plan plan = holding_plan(4.0 * hour, {});
  plan.surfacing.emplace();
  plan.surfacing->waypoints.resize(3);
  plan.surfacing->waypoints[1] = {.may_surface = false, .least_upper_turn = {40.0}};

  const auto written = write_goto_lists(plan, {});

  ASSERT_TRUE(written.has_value());
  EXPECT_EQ(written->files.size(), 1U);
  EXPECT_THAT(messages::sentences(written->messages),
              Contains(HasSubstr("where the vehicle must not surface")));
}

TEST(HoldOrder, IsNoLineThatIsFlownToAndFro) {
  const std::string head =
      "behavior_name=goto_list\n<start:b_arg>\n\tb_arg: num_legs_to_run(nodim) -1\n"
      "\tb_arg: num_waypoints(nodim) 2\n<end:b_arg>\n<start:waypoints>\n-5200.0000 4730.0000\n";
  const auto list_to = [&](const char* row) {
    return read_document("goto_l10.ma", head + row + "\n<end:waypoints>\n");
  };

  EXPECT_TRUE(hold_order(list_to("-5200.0000 4730.5000")).has_value());
  EXPECT_FALSE(hold_order(list_to("-5200.0000 4745.0000")).has_value());
}

}  // namespace
}  // namespace floeplan::mission::hold_lists_test
