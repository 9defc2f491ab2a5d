#include "engine/mission/checking/ice_check.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/mission/checking/flight_check.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/mission_set.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::mission::ice_check_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

const geo::LonLat start{-54.0, 69.0};

/// Ice of 90 % in the middle third of the way eastwards along 69 N to 51 W, its keels 18 m deep with the margin. In
/// open water otherwise, which ends abruptly: from one node of the grid to the next.
ocean::Environment sea_with_ice(double from_deg = -53.05, double to_deg = -51.95) {
  ocean::Environment sea;
  sea.bathymetry = support::bathymetry_from([](geo::LonLat) { return 500.0; });
  sea.ice = support::ice_from(
      [=](geo::LonLat p, double) { return p.lon_deg > from_deg && p.lon_deg < to_deg ? 0.9 : 0.0; }, {0.0},
      1.0);
  return sea;
}

Document list(const std::vector<std::string>& rows, int legs = -2) {
  std::string text = "behavior_name=goto_list\n<start:b_arg>\nb_arg: num_legs_to_run(nodim) " +
                     std::to_string(legs) +
                     "\nb_arg: list_when_wpt_dist(m) 100\nb_arg: num_waypoints(nodim) " +
                     std::to_string(rows.size()) + "\n<end:b_arg>\n<start:waypoints>\n";
  for (const std::string& row : rows) text += row + "\n";
  return read_document("goto_l10.ma", text + "<end:waypoints>\n");
}

/// To the east of the ice, with a stop in open water, below the ice, and in open water.
Document list_through() { return list({"-5318.0 6900.0", "-5230.0 6900.0", "-5100.0 6900.0"}); }

Document yo(int climb_m) {
  return read_document("yo10.ma",
                       "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 196\nb_arg: "
                       "d_target_altitude(m) 10\nb_arg: c_target_depth(m) " +
                           std::to_string(climb_m) + "\n<end:b_arg>\n");
}

Document surfacing(int start_when, int when_secs = 1200) {
  return read_document("surfac10.ma", "behavior_name=surface\n<start:b_arg>\nb_arg: start_when(enum) " +
                                          std::to_string(start_when) + "\nb_arg: when_secs(sec) " +
                                          std::to_string(when_secs) + "\n<end:b_arg>\n");
}

/// The files with the messages of the check in this sea.
std::vector<Document> checked(std::vector<Document> files, const ocean::Environment& sea) {
  planning::PlanRequest request = support::eastward_request();
  request.under_ice.current_uncertainty = {0.0};
  check_flight(files, sea, start, request);
  return files;
}

auto says(const std::string& code, Severity severity, int line, const std::string& text) {
  return Contains(AllOf(Field(&Message::code, code), Field(&Message::severity, severity),
                        Field(&Message::line, line), Field(&Message::text, HasSubstr(text))));
}

auto says_nothing_of(const std::string& code) { return Not(Contains(Field(&Message::code, code))); }

TEST(IceCheck, RejectsAYoThatClimbsIntoTheIce) {
  const auto high = checked({list_through(), yo(5)}, sea_with_ice());
  const auto low = checked({list_through(), yo(18)}, sea_with_ice());

  EXPECT_THAT(high[0].messages, says("ice_above_climb", Severity::error, 9, "must be at 18 m or deeper"));
  EXPECT_THAT(high[0].messages, says("ice_above_climb", Severity::error, 10, "climbs to 5 m"));
  EXPECT_THAT(high[0].messages, says_nothing_of("route_clear"));
  EXPECT_THAT(low[0].messages, says_nothing_of("ice_above_climb"));
  EXPECT_THAT(low[0].messages, Contains(Field(&Message::code, "route_clear")));
}

TEST(IceCheck, RejectsAYoThatClimbsIntoTheKeelOfAnIcebergThatItMayPassUnder) {
  ocean::Environment sea = sea_with_ice(0.0, 0.0);
  sea.icebergs = {support::iceberg_at({-51.8, 69.0}, 200.0)};
  sea.icebergs.front().draft = core::Metres{60.0};
  planning::PlanRequest request = support::eastward_request();
  request.icebergs.pass_under = true;
  std::vector<Document> files{list_through(), yo(5)};

  check_flight(files, sea, start, request);

  EXPECT_THAT(files[0].messages, Contains(Field(&Message::code, "ice_above_climb")));
}

TEST(IceCheck, RejectsAListThatEndsBelowIceAndWarnsOfOneThatTheErrorMayEndThere) {
  const auto below = checked({list({"-5230.0 6900.0"})}, sea_with_ice());
  const auto near_ice = checked({list({"-5150.0 6900.0"})}, sea_with_ice());
  const auto far = checked({list_through()}, sea_with_ice());
  const auto round = checked({list({"-5230.0 6900.0", "-5230.0 6912.0"}, -1)}, sea_with_ice());

  EXPECT_THAT(below[0].messages, says("list_ends_below_ice", Severity::error, 8, "the list ends here"));
  EXPECT_THAT(near_ice[0].messages, says("list_ends_near_ice", Severity::warning, 8, "m beyond the ice"));
  EXPECT_EQ(far[0].verdict(), Verdict::warn);  // of data that are missing alone
  EXPECT_THAT(round[0].messages, says_nothing_of("list_ends_below_ice"));
}

TEST(IceCheck, WarnsOfAListThatEndsWhereNothingIsKnownOfTheIce) {
  ocean::Environment sea = sea_with_ice();
  sea.ice = support::ice_from([](geo::LonLat p, double) { return p.lon_deg > -52.0 ? std::nan("") : 0.0; },
                              {0.0}, 1.0);

  const auto files = checked({list({"-5130.0 6900.0"})}, sea);

  EXPECT_THAT(files[0].messages, says("list_end_unknown", Severity::warning, 8, "where the ice is unknown"));
  EXPECT_EQ(files[0].verdict(), Verdict::warn);
}

TEST(IceCheck, RejectsSurfacingsBelowIce) {
  const auto hit = checked({list_through(), surfacing(8)}, sea_with_ice());
  const auto every = checked({list_through(), surfacing(9, 10'800)}, sea_with_ice());
  const auto silent = checked({list_through(), surfacing(12, 10'800)}, sea_with_ice());
  const auto patient = checked({list_through(), surfacing(12, 864'000)}, sea_with_ice());
  const auto science = checked({list_through(), surfacing(11)}, sea_with_ice());
  const auto done = checked({list_through(), surfacing(3)}, sea_with_ice());

  EXPECT_THAT(hit[0].messages,
              says("surfaces_below_ice", Severity::error, 9, "surfac10.ma orders a surfacing at this"));
  EXPECT_THAT(every[1].messages, says("surfaces_below_ice", Severity::error, 3, "legs 2 to 3 of the route"));
  EXPECT_THAT(silent[1].messages,
              says("surfaces_below_ice", Severity::error, 3, "after 3 h without contact"));
  EXPECT_THAT(patient[1].messages, says_nothing_of("surfaces_below_ice"));
  EXPECT_THAT(science[1].messages, says("surfaces_below_ice", Severity::warning, 3, "at any time"));
  EXPECT_THAT(done[1].messages, says_nothing_of("surfaces_below_ice"));
}

TEST(IceCheck, TakesContactAtWaypointsIntoAccount) {
  const Document rows = list({"-5318.0 6900.0", "-5100.0 6900.0"});
  Document hits = read_document("surfac11.ma",
                                "behavior_name=surface\n<start:b_arg>\nb_arg: start_when(enum) 8\n"
                                "<end:b_arg>\n");
  const int hours_below = 80;  // 92 km at 0.35 m/s from the first row on, 22 h before that

  const auto alone = checked({rows, surfacing(12, hours_below * 3600)}, sea_with_ice());
  const auto in_touch = checked({rows, surfacing(12, hours_below * 3600), hits}, sea_with_ice());

  EXPECT_THAT(alone[1].messages, Contains(Field(&Message::code, "surfaces_below_ice")));
  EXPECT_THAT(in_touch[1].messages, says_nothing_of("surfaces_below_ice"));
}

TEST(IceCheck, JudgesOnlyTheSurfacingsThatTheMissionAsksFor) {
  const Document mission = read_document("a.mi",
                                         "behavior: abend\nb_arg: overdepth(m) 200\nbehavior: goto_list\n"
                                         "b_arg: args_from_file(enum) 10\nbehavior: yo\n"
                                         "b_arg: args_from_file(enum) 10\n");

  const auto files = checked({mission, list_through(), yo(18), surfacing(9)}, sea_with_ice());

  EXPECT_THAT(files[3].messages, says_nothing_of("surfaces_below_ice"));
}

TEST(IceCheck, RejectsTheTargetsOfASeagliderBelowIce) {
  const auto files =
      checked({read_document("targets", "WPT001 lat=6900.0000 lon=-5100.0000 radius=100 goto=WPT001\n")},
              sea_with_ice());

  EXPECT_THAT(files[0].messages, says("surfaces_below_ice", Severity::error, 0, "after every dive"));
}

TEST(IceCheck, LeavesTheListOfARecoveryOutOfTheWay) {
  Document recovery = list_through();
  recovery.name = "goto_l98.ma";

  const auto files = checked({list({"-5318.0 6900.0"}), recovery}, sea_with_ice());

  EXPECT_THAT(files[1].messages, Contains(Field(&Message::code, "recovery_list")));
  EXPECT_EQ(files[1].verdict(), Verdict::ok);
  EXPECT_EQ(route_of({recovery}).stops.size(), 3u);
}

/// Law: the check finds no fault, in the same sea, in the files that the writer makes of a plan through ice.
TEST(IceCheck, HasNothingAgainstWhatTheWriterMakes) {
  int written = 0;
  support::for_each_seed(30, [&](std::mt19937_64& rng) {
    const double from_deg = support::uniform(rng, -53.9, -52.6);
    const ocean::Environment sea = sea_with_ice(from_deg, from_deg + support::uniform(rng, 0.1, 1.4));
    planning::PlanRequest request = support::eastward_request();
    std::vector<geo::LonLat> places{start};
    for (double lon_deg = -53.5; lon_deg < -51.0; lon_deg += support::uniform(rng, 0.2, 0.9))
      places.push_back({lon_deg, support::uniform(rng, 68.95, 69.05)});
    const auto plan = planning::evaluate_route(sea, places, request);
    ASSERT_TRUE(plan.has_value());
    MissionSetOptions options;
    options.vehicle = request.vehicle;
    options.under_ice = UnderIce{{start}};
    const auto set = write_mission_set(*plan, options);
    if (!set) return;
    ++written;
    std::vector<Document> files;
    for (const MissionFile& file : set->files) files.push_back(read_document(file.name, file.text));

    check_flight(files, sea, start, request);

    for (const Document& file : files) EXPECT_NE(file.verdict(), Verdict::reject) << file.name;
  });
  EXPECT_GT(written, 5);
}

}  // namespace
}  // namespace floeplan::mission::ice_check_test
