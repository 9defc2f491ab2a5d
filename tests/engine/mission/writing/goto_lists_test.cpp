#include "engine/mission/writing/goto_lists.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/mission/writing/list_parts.hpp"
#include "tests/engine/mission/list_reader.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission::goto_lists_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

core::UtcTime utc(const char* text) { return core::parse_iso8601(text).value(); }

planning::Plan plan_through(const std::vector<geo::LonLat>& places) {
  planning::Plan plan;
  plan.vehicle = "slocum-g3-200";
  plan.departure = utc("2026-11-20T06:00:00Z");
  plan.arrival = utc("2026-11-21T18:30:00Z");
  for (const geo::LonLat place : places) {
    planning::Waypoint waypoint;
    waypoint.place = place;
    if (!plan.waypoints.empty())
      waypoint.leg_length = geo::geodesic_between(plan.waypoints.back().place, place).length;
    plan.waypoints.push_back(waypoint);
  }
  return plan;
}

/// `count` waypoints on the parallel 69 N, half a degree (20 km) apart.
planning::Plan plan_eastwards(int count) {
  std::vector<geo::LonLat> places;
  for (int i = 0; i < count; ++i) places.push_back({-60.0 + 0.5 * i, 69.0});
  return plan_through(places);
}

TEST(GotoLists, ReadAsTheFormatReferencePrintsThem) {
  planning::Plan plan = plan_through({{-53.2, 69.2}, {-52.75, 69.0}, {-51.5, 69.175}});
  plan.datasets = {
      {.id = "currents-1234abcd", .kind = "currents", .name = "demo", .sha256 = "1234abcd5678ef90aabb"}};

  const auto lists = write_goto_lists(plan, {.origin = {.plan_id = "p-0123456789ab",
                                                        .plan_name = "to the mouth",
                                                        .generated = utc("2026-11-19T12:00:00Z"),
                                                        .written_by = "floeplan 0.1.0"}});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(lists->messages, IsEmpty());
  EXPECT_THAT(lists->files, ElementsAre(MissionFile{
                                "goto_l10.ma",
                                "behavior_name=goto_list\n"
                                "# goto_l10.ma, list 1 of 1: waypoints 1 to 2 of 2\n"
                                "# plan to the mouth\n"
                                "# plan id p-0123456789ab\n"
                                "# vehicle slocum-g3-200\n"
                                "# departure 2026-11-20T06:00:00Z, arrival 2026-11-21T18:30:00Z\n"
                                "# data currents-1234abcd sha256 1234abcd5678\n"
                                "# written by floeplan 0.1.0 at 2026-11-19T12:00:00Z\n"
                                "# No exported file has been tried on a vehicle. Check it before use.\n"
                                "# The start of the plan is left out: the vehicle is there and heads for the "
                                "first row.\n"
                                "\n"
                                "<start:b_arg>\n"
                                "\tb_arg: num_legs_to_run(nodim) -2\n"
                                "\tb_arg: start_when(enum) 0\n"
                                "\tb_arg: list_stop_when(enum) 7\n"
                                "\tb_arg: list_when_wpt_dist(m) 500\n"
                                "\tb_arg: initial_wpt(enum) 0\n"
                                "\tb_arg: num_waypoints(nodim) 2\n"
                                "<end:b_arg>\n"
                                "<start:waypoints>\n"
                                "-5245.0000\t6900.0000\n"
                                "-5130.0000\t6910.5000\n"
                                "<end:waypoints>\n"}));
}

TEST(GotoLists, OfAPlanWithoutANameHaveNoLineForIt) {
  const auto lists = write_goto_lists(plan_eastwards(3), {.origin = {.plan_id = "p-01"}});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(lists->files.at(0).text, HasSubstr("of 2\n# plan id p-01\n"));
}

TEST(GotoLists, SplitALongPlanIntoConsecutiveNumbersAndSaySo) {
  const auto lists = write_goto_lists(plan_eastwards(18), {.first_number = 7});

  ASSERT_TRUE(lists.has_value());
  std::vector<std::string> names;
  std::vector<std::size_t> rows;
  for (const MissionFile& file : lists->files) {
    names.push_back(file.name);
    rows.push_back(support::read_goto_list(file.text).waypoints.size());
  }
  EXPECT_THAT(names, ElementsAre("goto_l07.ma", "goto_l08.ma", "goto_l09.ma"));
  EXPECT_THAT(rows, ElementsAre(8u, 8u, 1u));
  EXPECT_THAT(messages::sentences(lists->messages), ElementsAre(HasSubstr("Send the next list")));
}

TEST(GotoLists, NeverUseTheNumbersOfTheFirmware) {
  const auto fits = write_goto_lists(plan_eastwards(10), {.first_number = 96});
  const auto too_far = write_goto_lists(plan_eastwards(10), {.first_number = 97});

  ASSERT_TRUE(fits.has_value());
  EXPECT_EQ(fits->files.back().name, "goto_l97.ma");
  ASSERT_FALSE(too_far.has_value());
  EXPECT_THAT(too_far.error(), ElementsAre(Field(&core::Violation::field, "/number")));
}

TEST(GotoLists, CannotBeInjectedIntoByNames) {
  planning::Plan plan = plan_eastwards(3);
  plan.vehicle = "x\n<start:b_arg>";
  plan.datasets = {{.id = "d\n<end:waypoints>", .kind = "", .name = "", .sha256 = "\r\n1"}};

  const auto lists =
      write_goto_lists(plan, {.origin = {.plan_id = std::string(300, 'x') + "\n1 2",
                                         .plan_name = "bay\n\tb_arg: num_waypoints(nodim) 1\n\xe2\x80\xa8",
                                         .written_by = "\n7 7\n"}});

  ASSERT_TRUE(lists.has_value());
  const support::ReadList list = support::read_goto_list(lists->files.at(0).text);
  EXPECT_EQ(list.waypoints.size(), 2u);
  EXPECT_EQ(list.b_args.at("num_waypoints(nodim)"), 2.0);
}

TEST(GotoLists, TakeARadiusBelowHalfOfTheShortestLeg) {
  const geo::LonLat start{-53.0, 69.0};
  const geo::LonLat middle =
      geo::geodesic_destination(start, geo::Bearing::degrees(90.0), core::Metres{5000.0});
  const geo::LonLat end = geo::geodesic_destination(middle, geo::Bearing::degrees(0.0), core::Metres{300.5});

  const auto lists = write_goto_lists(plan_through({start, middle, end}), {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_EQ(support::read_goto_list(lists->files.at(0).text).b_args.at("list_when_wpt_dist(m)"), 150.0);
  EXPECT_THAT(lists->messages, IsEmpty());
}

TEST(GotoLists, WarnWhenALegIsTooShortForAnyRadius) {
  const auto lists = write_goto_lists(plan_through({{0.0, 69.0}, {1.0, 69.0}, {1.0, 69.0001}}), {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_EQ(support::read_goto_list(lists->files.at(0).text).b_args.at("list_when_wpt_dist(m)"), 10.0);
  EXPECT_THAT(messages::sentences(lists->messages), ElementsAre(HasSubstr("may skip a waypoint")));
}

TEST(GotoLists, WarnWhenTheGivenRadiusIsLargerThanAClearance) {
  planning::Plan plan = plan_eastwards(3);
  plan.clearances.iceberg = core::Metres{400.0};
  plan.clearances.land = core::Metres{5000.0};

  const auto lists = write_goto_lists(plan, {.radius = core::Metres{450.0}});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(messages::sentences(lists->messages), ElementsAre(HasSubstr("an iceberg at 400 m")));
}

TEST(GotoLists, WarnOfLongLegsPolesAndLongLists) {
  const auto lists =
      write_goto_lists(plan_through({{0.0, 83.0}, {0.0, 83.5}, {0.0, 85.0}}), {.max_waypoints = 12});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(messages::sentences(lists->messages),
              ElementsAre(HasSubstr("the vendor documents only 8"), HasSubstr("leg to waypoint 2 is 168 km"),
                          HasSubstr("beyond 84° N")));
}

TEST(GotoLists, ReportEveryFaultAtOnce) {
  const auto lists = write_goto_lists(plan_through({{0.0, 89.5}, {400.0, 0.0}}),
                                      {.max_waypoints = 0, .radius = core::Metres{std::nan("")}});

  ASSERT_FALSE(lists.has_value());
  std::vector<std::string> fields;
  for (const core::Violation& violation : lists.error()) fields.push_back(violation.field);
  EXPECT_THAT(fields, ElementsAre("/waypoints/0", "/waypoints/1", "/max_waypoints", "/radius_m"));
}

TEST(GotoLists, RefuseAPlanWithoutAGoal) {
  EXPECT_THAT(write_goto_lists(plan_eastwards(1), {}).error(),
              Contains(Field(&core::Violation::field, "/waypoints")));
  EXPECT_THAT(write_goto_lists(plan_eastwards(0), {}).error(),
              Contains(Field(&core::Violation::field, "/waypoints")));
}

TEST(GotoLists, ContinueOnlyTheFirstListWhenAskedTo) {
  const auto lists = write_goto_lists(plan_eastwards(12), {.initial_waypoint = -1});

  ASSERT_TRUE(lists.has_value());
  EXPECT_EQ(support::read_goto_list(lists->files.at(0).text).b_args.at("initial_wpt(enum)"), -1.0);
  EXPECT_EQ(support::read_goto_list(lists->files.at(1).text).b_args.at("initial_wpt(enum)"), 0.0);
  EXPECT_FALSE(write_goto_lists(plan_eastwards(3), {.initial_waypoint = 2}).has_value());
}

/// The waypoints of the plan at which its lists end.
std::vector<std::size_t> ends_of(const MissionFiles& lists) {
  std::vector<std::size_t> ends;
  std::size_t rows = 0;
  for (const MissionFile& file : lists.files)
    ends.push_back(rows += support::read_goto_list(file.text).waypoints.size());
  return ends;
}

/// Some waypoints of it lie below ice.
planning::Plan plan_below_ice(int count, const std::vector<std::size_t>& below) {
  planning::Plan plan = plan_eastwards(count);
  plan.surfacing.emplace();
  plan.surfacing->longest_without = core::Seconds{7200.0};
  plan.surfacing->waypoints.resize(static_cast<std::size_t>(count));
  for (auto& state : plan.surfacing->waypoints) state.leg_upper_turn = core::Metres{0.0};
  for (const std::size_t i : below)
    plan.surfacing->waypoints[i] = {.may_surface = false,
                                    .since_surfacing = core::Seconds{3600.0},
                                    .position_error = {},
                                    .least_upper_turn = core::Metres{22.0},
                                    .leg_upper_turn = core::Metres{22.0}};
  return plan;
}

TEST(GotoLists, EndWhereTheVehicleMaySurface) {
  const auto lists = write_goto_lists(plan_below_ice(14, {4, 5, 6, 7, 8, 9}), {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(ends_of(*lists), ElementsAre(3u, 11u, 13u));
}

TEST(GotoLists, AreRefusedForMoreWaypointsBelowIceThanAListHolds) {
  const auto lists = write_goto_lists(plan_below_ice(14, {3, 4, 5, 6, 7, 8, 9, 10}), {});

  ASSERT_FALSE(lists.has_value());
  EXPECT_THAT(lists.error(), ElementsAre(testing::AllOf(
                                 Field(&core::Violation::field, "/waypoints"),
                                 Field(&core::Violation::rule, HasSubstr("where waypoints 3 to 10 lie")))));
}

TEST(GotoLists, AreRefusedForAPlanThatEndsBelowIce) {
  const auto lists = write_goto_lists(plan_below_ice(3, {2}), {});

  ASSERT_FALSE(lists.has_value());
  EXPECT_THAT(lists.error(), ElementsAre(Field(&core::Violation::field, "/waypoints/2")));
}

TEST(GotoLists, ThatNoVehicleFliesMayEndBelowIce) {
  const auto lists =
      write_goto_lists(plan_below_ice(14, {3, 4, 5, 6, 7, 8, 9, 10, 13}), {.may_end_below_ice = true});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(ends_of(*lists), ElementsAre(2u, 10u, 12u, 13u));
}

TEST(GotoLists, NeverEndBelowAnIceberg) {
  planning::Plan plan = plan_eastwards(12);
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i)
    plan.waypoints[i].eta = plan.departure + core::Seconds{3600.0 * static_cast<double>(i)};
  plan.passed_under = {{"B-17",
                        {{40.0}, true, {50.0}, {69.5}},
                        plan.departure + core::Seconds{7.5 * 3600.0},
                        plan.departure + core::Seconds{8.5 * 3600.0}}};

  const auto lists = write_goto_lists(plan, {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(ends_of(*lists), ElementsAre(7u, 11u));
}

TEST(GotoLists, EndWhereNothingIsKnownOfTheIceOnlyIfTheyMustAndSaySo) {
  planning::Plan plan = plan_below_ice(14, {4, 5, 6, 7, 8});
  for (std::size_t i = 9; i < 14; ++i) plan.surfacing->waypoints[i].may_surface = false;

  const auto lists = write_goto_lists(plan, {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(ends_of(*lists), ElementsAre(3u, 11u, 13u));
  EXPECT_THAT(messages::sentences(lists->messages),
              Contains(HasSubstr("goto_l11.ma ends at waypoint 11, where the ice is unknown")));
  EXPECT_THAT(messages::sentences(lists->messages), testing::Not(Contains(HasSubstr("goto_l10.ma ends"))));
}

TEST(GotoLists, SayHowLongTheFirstIsFlownBeforeAnyCurrentIsKnown) {
  const auto says = Contains(HasSubstr("to the first surfacing"));

  EXPECT_THAT(messages::sentences(write_goto_lists(plan_below_ice(14, {4, 5, 6, 7, 8}), {})->messages), says);
  EXPECT_THAT(messages::sentences(write_goto_lists(plan_below_ice(14, {}), {})->messages),
              testing::Not(says));
}

/// A plan below ice until 2 km before its goal, where the position error is 600 m.
planning::Plan plan_out_of_the_ice() {
  planning::Plan plan = plan_below_ice(3, {1});
  auto& states = plan.surfacing->waypoints;
  states[0].error_without_fix = core::Metres{100.0};
  states[2].leg_upper_turn = core::Metres{22.0};
  states[2].ice_free_before = core::Metres{2000.0};
  states[2].error_without_fix = core::Metres{700.0};
  return plan;
}

TEST(GotoLists, AreRefusedWhereTheVehicleComesUpBeforeItIsOutOfTheIce) {
  planning::Plan plan = plan_out_of_the_ice();
  plan.surfacing->waypoints[2].ice_free_before = core::Metres{8.0};

  const auto lists = write_goto_lists(plan, {});

  ASSERT_FALSE(lists.has_value());
  EXPECT_THAT(lists.error(), ElementsAre(testing::AllOf(
                                 Field(&core::Violation::field, "/waypoints/2"),
                                 Field(&core::Violation::rule, HasSubstr("8 m beyond the ice")),
                                 Field(&core::Violation::rule, HasSubstr("more than 10 m beyond the ice")))));
  EXPECT_TRUE(write_goto_lists(plan, {.may_end_below_ice = true}).has_value());
}

TEST(GotoLists, AreRefusedForARadiusThatReachesIntoTheIce) {
  const planning::Plan plan = plan_out_of_the_ice();

  EXPECT_TRUE(write_goto_lists(plan, {.radius = core::Metres{1990.0}}).has_value());
  EXPECT_FALSE(write_goto_lists(plan, {.radius = core::Metres{2000.0}}).has_value());
}

TEST(GotoLists, WarnWhereTheVehicleMayBeOffSoFarThatItComesUpBelowTheIce) {
  planning::Plan plan = plan_out_of_the_ice();
  plan.surfacing->waypoints[2].ice_free_before = core::Metres{300.0};

  const auto lists = write_goto_lists(plan, {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(lists->files.front().text, HasSubstr("list_when_wpt_dist(m) 299\n"));
  EXPECT_THAT(messages::sentences(lists->messages),
              Contains(testing::AllOf(HasSubstr("may therefore surface below the ice"),
                                      HasSubstr("more than 899 m from the ice"))));
}

/// Ice beside a route that never passes below ice does not count as ice before its start.
TEST(GotoLists, AreNotBeyondIceThatTheirWayDoesNotPassBelow) {
  planning::Plan plan = plan_below_ice(3, {});
  double way_m = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    way_m += plan.waypoints[i].leg_length.value_or(core::Metres{0.0}).value;
    plan.surfacing->waypoints[i].ice_free_before = core::Metres{way_m - 0.3};
    plan.surfacing->waypoints[i].error_without_fix = core::Metres{0.4 * way_m};
    plan.surfacing->waypoints[i].nearest_ice = core::Metres{10.0 * way_m + 1000.0};
  }

  EXPECT_THAT(messages::sentences(write_goto_lists(plan, {})->messages),
              testing::Not(Contains(HasSubstr("beyond the ice"))));
}

/// Ice far beside a route, or beyond the distance that the plan checks, is not the nearest ice of any
/// waypoint.
TEST(GotoLists, SayHowFarOffTheVehicleMayComeUpWhereNoIceIsKnown) {
  planning::Plan plan = plan_below_ice(3, {});
  for (std::size_t i = 0; i < 3; ++i)
    plan.surfacing->waypoints[i].error_without_fix = core::Metres{4000.0 * static_cast<double>(i)};
  const auto says = Contains(HasSubstr("position error of 8.0 km. Make sure"));
  EXPECT_THAT(messages::sentences(write_goto_lists(plan, {})->messages), says);

  plan.surfacing->waypoints[2].error_without_fix = core::Metres{4500.0};
  EXPECT_THAT(messages::sentences(write_goto_lists(plan, {})->messages),
              testing::Not(Contains(HasSubstr("with a position error of"))));
}

/// The plan has a fix every hour; the vehicle surfaces for it unless something is above it.
TEST(GotoLists, CountTheErrorSinceTheLastFixOfTheMission) {
  planning::Plan plan = plan_below_ice(3, {});
  plan.surfacing->longest_without = core::Seconds{0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    plan.waypoints[i].eta = plan.departure + core::Seconds{36'000.0 * static_cast<double>(i)};
    plan.surfacing->waypoints[i].error_without_fix = core::Metres{4000.0 * static_cast<double>(i)};
  }
  const auto says = Contains(HasSubstr("with a position error of"));
  const auto told = [&](double between_fixes_s) {
    return messages::sentences(
        write_goto_lists(plan, {.between_fixes = core::Seconds{between_fixes_s}})->messages);
  };

  EXPECT_THAT(messages::sentences(write_goto_lists(plan, {})->messages), says) << "no fix on the way";
  EXPECT_THAT(told(3600.0), testing::Not(says));
  EXPECT_THAT(told(50'400.0), Contains(HasSubstr("with a position error of 5.6 km"))) << "1.4 of 2 legs";
  EXPECT_THAT(told(90'000.0), Contains(HasSubstr("with a position error of 8.0 km"))) << "longer than the list";
}

/// After a fix the vehicle knows the current that it met before it.
TEST(GotoLists, CountTheCurrentsAgainstTheOneMeasuredBeforeTheLastFix) {
  planning::Plan plan = plan_below_ice(3, {});
  plan.surfacing->longest_without = core::Seconds{0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    plan.waypoints[i].eta = plan.departure + core::Seconds{36'000.0 * static_cast<double>(i)};
    plan.waypoints[i].current = geo::VelocityEn{{0.2}, {0.0}};
    plan.surfacing->waypoints[i].error_without_fix = core::Metres{0.0};
  }
  const ListPart part{.first = 1, .last = 2, .before = 0, .between_fixes = core::Seconds{18'000.0}};

  EXPECT_NEAR(error_of(plan, {1, 2}).value, 0.2 * 72'000.0, 1.0) << "no current is known at the start";
  EXPECT_NEAR(error_of(plan, part).value, 0.0, 1.0);
  plan.waypoints[2].current = geo::VelocityEn{{-0.1}, {0.0}};
  EXPECT_NEAR(error_of(plan, part).value, 0.0, 1.0) << "met before the last fix, too";
  plan.waypoints[1].eta += core::Seconds{27'000.0};
  EXPECT_NEAR(error_of(plan, part).value, 0.3 * 9000.0, 1.0) << "met after the last fix, for 9000 s";
}

/// Legs of 5 km eastwards at 0.25 m/s through the water, each flown in so much time, with these currents eastwards.
void set_legs(planning::Plan& plan, core::Seconds each, const std::vector<double>& currents_m_s) {
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    planning::Waypoint& leg = plan.waypoints[i];
    leg.eta = plan.departure + static_cast<double>(i) * each;
    leg.leg_length = core::Metres{5000.0};
    leg.course_deg = 90.0;
    leg.speed_through_water = core::MetresPerSecond{0.25};
    leg.current = geo::VelocityEn{{currents_m_s[i]}, {0.0}};
  }
}

/// If the current was against the vehicle on the list before, the vehicle assumes that it is slower than it
/// is.
TEST(GotoLists, SayHowMuchLongerTheVehicleIsUnderWayByItsOwnReckoning) {
  planning::Plan plan = plan_below_ice(3, {});
  set_legs(plan, core::Seconds{20'000.0}, {0.0, -0.125, 0.0});
  for (auto& state : plan.surfacing->waypoints) state.error_without_fix = core::Metres{0.0};

  const auto lists = write_goto_lists(plan, {.max_waypoints = 1});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(messages::sentences(lists->messages),
              Contains(HasSubstr("goto_l11.ma may take 5 h 33 min longer than planned")));
  EXPECT_THAT(messages::sentences(lists->messages),
              testing::Not(Contains(HasSubstr("goto_l10.ma may be flown"))));
}

TEST(GotoLists, OfAPlanThatDoesNotTellItsCurrentsSaySo) {
  const auto says = Contains(HasSubstr("without the currents on its legs"));
  planning::Plan plan = plan_out_of_the_ice();
  EXPECT_THAT(messages::sentences(write_goto_lists(plan, {})->messages), testing::Not(says))
      << "planned in still water";

  plan.datasets = {{.id = "currents-1", .kind = "currents", .name = "", .sha256 = ""}};
  EXPECT_THAT(messages::sentences(write_goto_lists(plan, {})->messages), says);
  plan.waypoints[2].current = geo::VelocityEn{};
  EXPECT_THAT(messages::sentences(write_goto_lists(plan, {})->messages), testing::Not(says));
}

/// A current that the vehicle has not measured adds its displacement to the position error.
TEST(GotoLists, CountWhatTheCurrentsOfThePlanCarryTheVehicle) {
  planning::Plan plan = plan_out_of_the_ice();
  for (std::size_t i = 0; i < 3; ++i) {
    plan.waypoints[i].eta = plan.departure + core::Seconds{10'000.0 * static_cast<double>(i)};
    plan.waypoints[i].current = geo::VelocityEn{{0.03}, {0.04}};
  }

  const auto once = write_goto_lists(plan, {});
  const auto each = write_goto_lists(plan, {.max_waypoints = 1, .may_end_below_ice = true});

  ASSERT_TRUE(once && each);
  EXPECT_THAT(messages::sentences(once->messages), Contains(HasSubstr("position error 1.6 km")))
      << "600 m, and 20,000 s at 0.05 m/s";
  EXPECT_THAT(messages::sentences(each->messages), testing::Not(Contains(HasSubstr("position error 1600 m"))))
      << "the second list begins where the current of the first one is known";
}

/// A vehicle that does not know of a current from astern assumes that it has farther to go, and goes on for
/// longer.
TEST(GotoLists, CountThatTheVehicleGoesOnUntilItTakesItselfToBeThere) {
  planning::Plan plan = plan_out_of_the_ice();
  set_legs(plan, core::Seconds{10'000.0}, {0.25, 0.25, 0.25});

  const auto lists = write_goto_lists(plan, {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(messages::sentences(lists->messages), Contains(HasSubstr("position error 10.6 km")))
      << "40,000 s at 0.25 m/s, and 600 m";
}

/// The first list ends in open water just in front of the ice that the second one passes below.
TEST(GotoLists, EndInFrontOfIceOnlyWhereTheyMustAndSaySo) {
  planning::Plan plan = plan_below_ice(6, {4});
  auto& states = plan.surfacing->waypoints;
  for (std::size_t i = 0; i < 6; ++i) {
    states[i].error_without_fix = core::Metres{500.0 * static_cast<double>(i)};
    states[i].ice_free_before = core::Metres{1e5};
  }
  states[3].nearest_ice = core::Metres{120.0};
  states[2].nearest_ice = core::Metres{1050.0};

  const auto free = write_goto_lists(plan, {.max_waypoints = 3});
  states[1].nearest_ice = core::Metres{40.0};
  const auto forced = write_goto_lists(plan, {.max_waypoints = 1, .may_end_below_ice = true});

  ASSERT_TRUE(free && forced);
  EXPECT_THAT(ends_of(*free), ElementsAre(2u, 5u));
  EXPECT_THAT(messages::sentences(forced->messages),
              Contains(testing::AllOf(HasSubstr("ends at waypoint 3, 120 m from the nearest ice"),
                                      HasSubstr("position error 500 m"),
                                      HasSubstr("may therefore surface below the ice"))));
}

TEST(GotoLists, GetASmallerRadiusWhereTheyEndNearIce) {
  planning::Plan plan = plan_out_of_the_ice();
  const auto usual = write_goto_lists(plan, {});
  plan.surfacing->waypoints[2].ice_free_before = core::Metres{800.0};

  const auto near_ice = write_goto_lists(plan, {});

  ASSERT_TRUE(usual && near_ice);
  EXPECT_THAT(usual->files.front().text, HasSubstr("list_when_wpt_dist(m) 500\n"));
  EXPECT_THAT(near_ice->files.front().text, HasSubstr("list_when_wpt_dist(m) 199\n"));
  EXPECT_THAT(messages::sentences(near_ice->messages),
              Contains(HasSubstr("800 m beyond the ice (waypoint radius 199 m, position error 600 m)")));
}

TEST(GotoLists, EndEarlierThanTheyMustWhereThatIsFartherFromTheIce) {
  planning::Plan plan = plan_below_ice(14, {4, 6});
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    plan.surfacing->waypoints[i].ice_free_before = core::Metres{30'000.0};
    plan.surfacing->waypoints[i].error_without_fix = core::Metres{100.0 * static_cast<double>(i)};
  }
  plan.surfacing->waypoints[8].ice_free_before = core::Metres{300.0};

  const auto lists = write_goto_lists(plan, {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(ends_of(*lists), ElementsAre(7u, 13u));
}

/// The disc of an iceberg already includes its position error, so the error is not added again.
TEST(GotoLists, KeepTheirRadiusAloneFromAnIcebergThatTheyPassUnder) {
  planning::Plan plan = plan_below_ice(3, {});
  for (std::size_t i = 0; i < 3; ++i) {
    const double hours = 14.0 * static_cast<double>(i);
    plan.waypoints[i].eta = plan.departure + core::Seconds{3600.0 * hours};
    plan.waypoints[i].speed_over_ground = core::MetresPerSecond{0.4};
    plan.surfacing->waypoints[i].ice_free_before = core::Metres{20'000.0 * static_cast<double>(i)};
    plan.surfacing->waypoints[i].error_without_fix = core::Metres{4000.0 * static_cast<double>(i)};
  }
  plan.surfacing->waypoints[2].leg_upper_turn = core::Metres{50.0};
  const core::UtcTime until = plan.waypoints[2].eta - core::Seconds{750.0};  // 300 m before the end
  plan.passed_under = {{"B-17", {{40.0}, true, {50.0}, {69.5}}, until - core::Seconds{3600.0}, until}};

  const auto usual = write_goto_lists(plan, {});
  const auto wide = write_goto_lists(plan, {.radius = core::Metres{310.0}});

  ASSERT_TRUE(usual.has_value());
  EXPECT_THAT(usual->files.front().text, HasSubstr("list_when_wpt_dist(m) 299\n"));
  ASSERT_FALSE(wide.has_value());
  EXPECT_THAT(wide.error(),
              ElementsAre(Field(&core::Violation::rule, HasSubstr("300 m beyond the iceberg"))));
}

TEST(GotoLists, OfAPlanThatDoesNotTellHowFarFromIceItEndsSaySo) {
  planning::Plan plan = plan_out_of_the_ice();
  for (auto& state : plan.surfacing->waypoints) state.ice_free_before.reset();

  const auto lists = write_goto_lists(plan, {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(messages::sentences(lists->messages), Contains(HasSubstr("Plan again before the flight")));
}

TEST(GotoLists, NameTheLegsOnTheThruster) {
  planning::Plan plan = plan_eastwards(6);
  for (const std::size_t i : {1U, 3U, 4U}) plan.waypoints[i].drive = vehicle::Drive::thruster;
  plan.waypoints[2].drive = plan.waypoints[5].drive = vehicle::Drive::buoyancy;

  const auto lists = write_goto_lists(plan, {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(messages::sentences(lists->messages),
              Contains(HasSubstr("the legs to waypoints 1, 3 to 4 are planned with the thruster")));
}

TEST(GotoLists, OfAnyPlanEndWhereTheVehicleMaySurfaceOrAreRefused) {
  int written = 0;
  support::for_each_seed(400, [&](std::mt19937_64& rng) {
    const int count = support::uniform_int(rng, 2, 40);
    const int max_waypoints = support::uniform_int(rng, 1, 9);
    std::vector<std::size_t> below;
    const double share = support::uniform(rng, 0.0, 0.9);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      if (support::uniform(rng, 0.0, 1.0) < share) below.push_back(i);
    const planning::Plan plan = plan_below_ice(count, below);

    const auto lists = write_goto_lists(plan, {.first_number = 0, .max_waypoints = max_waypoints});

    int run = 0;
    bool too_long = !plan.surfacing->waypoints.back().may_surface;
    for (std::size_t i = 1; i < plan.surfacing->waypoints.size(); ++i) {
      run = plan.surfacing->waypoints[i].may_surface ? 0 : run + 1;
      too_long = too_long || run >= max_waypoints;
    }
    ASSERT_EQ(lists.has_value(), !too_long);
    if (too_long) return;
    ++written;
    for (const std::size_t end : ends_of(*lists)) EXPECT_TRUE(plan.surfacing->waypoints[end].may_surface);
    EXPECT_EQ(ends_of(*lists).back(), plan.waypoints.size() - 1);
  });
  EXPECT_GT(written, 50);
}

TEST(GotoLists, OfAnyPlanReadBackWithinATenthOfAMetreOnEachAxis) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const auto places = support::random_places(rng, 2, 60);
    const int max_waypoints = support::uniform_int(rng, 1, 12);

    const auto lists =
        write_goto_lists(plan_through(places), {.first_number = 0, .max_waypoints = max_waypoints});

    ASSERT_TRUE(lists.has_value());
    std::vector<geo::LonLat> read;
    for (const MissionFile& file : lists->files) {
      const support::ReadList list = support::read_goto_list(file.text);
      ASSERT_EQ(list.b_args.at("num_waypoints(nodim)"), static_cast<double>(list.waypoints.size()));
      ASSERT_LE(list.waypoints.size(), static_cast<std::size_t>(max_waypoints));
      read.insert(read.end(), list.waypoints.begin(), list.waypoints.end());
    }
    ASSERT_EQ(read.size(), places.size() - 1);
    for (std::size_t i = 0; i < read.size(); ++i) {
      const geo::LonLat wanted = places[i + 1];
      EXPECT_LT(geo::geodesic_between(wanted, {wanted.lon_deg, read[i].lat_deg}).length.value, 0.1);
      EXPECT_LT(geo::geodesic_between(wanted, {read[i].lon_deg, wanted.lat_deg}).length.value, 0.1);
    }
  });
}

}  // namespace
}  // namespace floeplan::mission::goto_lists_test
