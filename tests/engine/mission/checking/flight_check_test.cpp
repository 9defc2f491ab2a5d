#include "engine/mission/checking/flight_check.hpp"

#include <gmock/gmock.h>

#include "engine/messages/data_messages.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/mission_set.hpp"
#include "tests/engine/mission/random_plan.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::mission::flight_check_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::SizeIs;

/// Eastwards along 69 N in three legs of 20 km.
const std::vector<geo::LonLat> eastwards{{-53.5, 69.0}, {-53.0, 69.0}, {-52.5, 69.0}, {-52.0, 69.0}};

ocean::Environment deep_sea() {
  ocean::Environment sea;
  sea.bathymetry = support::bathymetry_from([](geo::LonLat) { return 500.0; });
  return sea;
}

planning::PlanRequest request() { return support::eastward_request(); }

Document list(const std::string& rows, int count, int legs = -2) {
  return read_document(
      "goto_l10.ma",
      "behavior_name=goto_list\n<start:b_arg>\nb_arg: num_legs_to_run(nodim) " + std::to_string(legs) +
          "\nb_arg: list_when_wpt_dist(m) 500\nb_arg: num_waypoints(nodim) " + std::to_string(count) +
          "\n<end:b_arg>\n<start:waypoints>\n" + rows + "<end:waypoints>\n");
}

Document yo(double depth_m, double altitude_m) {
  return read_document("yo10.ma", "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) " +
                                      std::to_string(depth_m) + "\nb_arg: d_target_altitude(m) " +
                                      std::to_string(altitude_m) + "\n<end:b_arg>\n");
}

auto has(const std::string& code, Severity severity, int line) {
  return Contains(
      AllOf(Field(&Message::code, code), Field(&Message::severity, severity), Field(&Message::line, line)));
}

TEST(RouteCheck, FindsNothingInAClearSeaAndTimesTheRoute) {
  const RouteCheck check = check_route(deep_sea(), eastwards, request());

  EXPECT_THAT(check.findings, IsEmpty());
  ASSERT_TRUE(check.timing.has_value());
  EXPECT_NEAR(check.timing->travel_time().count(), check.timing->distance.value / 0.35, 60.0);
}

TEST(RouteCheck, NamesEveryClosedLegAndNoOther) {
  ocean::Environment sea = deep_sea();
  sea.icebergs = {support::iceberg_at({-53.25, 69.0}, 200.0), support::iceberg_at({-52.25, 69.0}, 200.0)};

  const RouteCheck check = check_route(sea, eastwards, request());

  ASSERT_THAT(check.findings, SizeIs(2));
  EXPECT_EQ(check.findings[0].place, 1U);
  EXPECT_EQ(check.findings[1].place, 3U);
  EXPECT_EQ(check.findings[0].code, "near_iceberg");
  EXPECT_TRUE(check.findings[0].dangerous);
  EXPECT_FALSE(check.timing.has_value());
}

TEST(RouteCheck, NamesAShallowStartAndAShallowGoal) {
  ocean::Environment sea;
  sea.bathymetry = support::bathymetry_from(
      [](geo::LonLat place) { return place.lon_deg < -53.2 || place.lon_deg > -52.3 ? 5.0 : 500.0; });

  const RouteCheck check = check_route(sea, eastwards, request());

  ASSERT_FALSE(check.findings.empty());
  EXPECT_EQ(check.findings.front().place, 0U);
  EXPECT_EQ(check.findings.front().code, "start_too_shallow");
  EXPECT_EQ(check.findings.back().place, 3U);
}

TEST(RouteCheck, DoesNotCallTheUnknownDangerous) {
  const auto currents = support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{}; }, 6);
  ocean::Environment sea = deep_sea();
  sea.currents = currents;

  const RouteCheck check = check_route(sea, eastwards, request());

  ASSERT_THAT(check.findings, SizeIs(1));
  EXPECT_EQ(check.findings[0].code, "outside_data");
  EXPECT_FALSE(check.findings[0].dangerous);
}

TEST(RouteCheck, TakesRepeatedAndFarPlacesAsTheyAre) {
  EXPECT_THAT(check_route(deep_sea(), {eastwards[0], eastwards[0]}, request()).findings, IsEmpty());
  EXPECT_THAT(check_route(deep_sea(), {}, request()).findings, IsEmpty());
  const RouteCheck far = check_route(deep_sea(), {eastwards[0], {120.0, -40.0}}, request());
  ASSERT_THAT(far.findings, SizeIs(1));
  EXPECT_EQ(far.findings[0].code, "leg_too_long");
  EXPECT_THROW((void)check_route(deep_sea(), {{0.0, 99.0}, {0.0, 0.0}}, request()), std::invalid_argument);
}

TEST(DepthCheck, FindsTheLegOnWhichABlindYoMeetsTheBed) {
  ocean::Environment sea;
  sea.bathymetry =
      support::bathymetry_from([](geo::LonLat place) { return place.lon_deg > -52.4 ? 100.0 : 500.0; });

  const auto blind = check_depths(sea, eastwards, {core::Metres{180.0}, false});
  ASSERT_THAT(blind, SizeIs(1));
  EXPECT_EQ(blind[0].place, 3U);
  EXPECT_THAT(check_depths(sea, eastwards, {core::Metres{180.0}, true}), IsEmpty());
  EXPECT_THAT(check_depths(sea, eastwards, {core::Metres{80.0}, false}), IsEmpty());
}

TEST(DepthCheck, FindsTheLegThatLeavesAYoBelowIceNoRoom) {
  ocean::Environment sea;
  sea.bathymetry =
      support::bathymetry_from([](geo::LonLat place) { return place.lon_deg > -52.4 ? 69.0 : 300.0; });
  DiveArguments dive{.target_depth = core::Metres{196.0},
                     .altimeter = true,
                     .altitude = core::Metres{10.0},
                     .climb_to = core::Metres{58.0}};

  const auto below_ice = check_depths(sea, eastwards, dive);
  ASSERT_THAT(below_ice, SizeIs(1));
  EXPECT_EQ(below_ice[0].place, 3U);
  EXPECT_EQ(below_ice[0].code, "bottom_above_climb");
  EXPECT_TRUE(below_ice[0].dangerous);
  dive.climb_to = core::Metres{57.0};
  EXPECT_THAT(check_depths(sea, eastwards, dive), IsEmpty());
}

TEST(FlightCheck, PutsWhatTheSeaDoesToALegAtItsRow) {
  ocean::Environment sea = deep_sea();
  sea.icebergs = {support::iceberg_at({-52.75, 69.0}, 200.0)};
  std::vector<Document> files{list("-5300.0 6900.0\n-5230.0 6900.0\n", 2)};

  check_flight(files, sea, eastwards[0], request());

  EXPECT_EQ(files[0].verdict(), Verdict::reject);
  EXPECT_THAT(files[0].messages, has("near_iceberg", Severity::error, 9));
}

TEST(FlightCheck, NotesTheTimesOfAClearRoute) {
  std::vector<Document> files{list("-5300.0 6900.0\n-5230.0 6900.0\n", 2)};

  check_flight(files, deep_sea(), std::nullopt, request());

  EXPECT_EQ(files[0].verdict(), Verdict::ok);
  EXPECT_THAT(files[0].messages, has("route_clear", Severity::note, 0));
}

TEST(FlightCheck, WarnsOfWhatItsAnswerDoesNotRestOn) {
  ocean::Environment sea = deep_sea();
  sea.messages = {messages::data_message<"icebergs-left-out">()};
  std::vector<Document> files{list("-5300.0 6900.0\n-5230.0 6900.0\n", 2)};

  check_flight(files, sea, std::nullopt, request());

  EXPECT_EQ(files[0].verdict(), Verdict::warn);
  EXPECT_THAT(files[0].messages, has("sea_data", Severity::warning, 0));
  EXPECT_THAT(files[0].messages, has("route_clear", Severity::note, 0));
}

TEST(FlightCheck, FollowsAListThatGoesRoundBackToItsFirstRow) {
  const std::vector<Document> files{list("-5300.0 6900.0\n-5230.0 6900.0\n-5230.0 6912.0\n", 3, -1)};

  const FlightRoute route = route_of(files);

  ASSERT_THAT(route.stops, SizeIs(4));
  EXPECT_EQ(route.stops[3].place, route.stops[0].place);
}

TEST(FlightCheck, RejectsAYoThatClimbsNoHigherThanTheBedOfABank) {
  ocean::Environment sea;
  sea.bathymetry = support::bathymetry_from([](geo::LonLat) { return 45.0; });
  std::vector<Document> files{
      list("-5300.0 6900.0\n-5230.0 6900.0\n", 2),
      read_document("yo10.ma",
                    "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 196\nb_arg: "
                    "d_target_altitude(m) 10\nb_arg: c_target_depth(m) 58\n<end:b_arg>\n")};

  check_flight(files, sea, std::nullopt, request());

  EXPECT_THAT(files[0].messages, has("bottom_above_climb", Severity::error, 9));
}

/// A sea whose currents run with the vehicle near the surface and against it far below.
ocean::Environment sheared_sea() {
  ocean::Environment sea = deep_sea();
  sea.currents = support::sheared_currents(400);
  return sea;
}

TEST(FlightCheck, TimesTheRouteAtTheDepthsThatTheYoTurnsAt) {
  planning::PlanRequest slow = request();
  slow.vehicle.speed_through_water = {0.15};
  const auto documents_with = [&](double climb_m) {
    std::vector<Document> documents{
        list("-5300.0 6900.0\n-5230.0 6900.0\n", 2),
        read_document("yo10.ma",
                      "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 196\n"
                      "b_arg: d_target_altitude(m) 10\nb_arg: c_target_depth(m) " +
                          std::to_string(climb_m) + "\n<end:b_arg>\n")};
    check_flight(documents, sheared_sea(), geo::LonLat{-53.5, 69.0}, slow);
    return documents;
  };

  EXPECT_THAT(documents_with(5.0)[0].messages,
              testing::Not(Contains(Field(&Message::severity, Severity::error))));
  EXPECT_THAT(documents_with(90.0)[0].messages, Contains(AllOf(Field(&Message::code, "current_too_strong"),
                                                               Field(&Message::severity, Severity::error))));
}

TEST(FlightCheck, RunsTheThrusterOnlyWhereTheYoTurnsItOn) {
  planning::PlanRequest with_thruster = request();
  with_thruster.vehicle = *vehicle::find_profile("slocum-g3-200-thruster");
  ocean::Environment sea = deep_sea();
  sea.currents =
      support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{{-0.4}, {0.0}}; }, 400);
  const auto documents_with = [&](const std::string& thruster) {
    std::vector<Document> documents{
        list("-5300.0 6900.0\n-5230.0 6900.0\n", 2),
        read_document("yo10.ma", "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 196\n" +
                                     thruster + "b_arg: c_target_depth(m) 5\n<end:b_arg>\n")};
    check_flight(documents, sea, geo::LonLat{-53.5, 69.0}, with_thruster);
    return documents;
  };

  EXPECT_THAT(documents_with("b_arg: d_use_thruster(enum) 4\nb_arg: c_use_thruster(enum) 4\n")[0].messages,
              testing::Not(Contains(Field(&Message::severity, Severity::error))));
  EXPECT_THAT(documents_with("")[0].messages, Contains(Field(&Message::code, "current_too_strong")));
}

TEST(FlightCheck, RejectsABlindYoAboveAShallowBed) {
  ocean::Environment sea;
  sea.bathymetry = support::bathymetry_from([](geo::LonLat) { return 150.0; });
  std::vector<Document> files{list("-5300.0 6900.0\n-5230.0 6900.0\n", 2), yo(180.0, -1.0)};

  check_flight(files, sea, std::nullopt, request());

  EXPECT_THAT(files[0].messages, has("bottom_above_target", Severity::error, 9));
}

TEST(FlightCheck, NamesWhatAbortsAMission) {
  const std::string head = "behavior: abend\nb_arg: overdepth(m) 150\nb_arg: max_wpt_distance(m) 5000\n";
  std::vector<Document> files{
      read_document("a.mi", head + "behavior: goto_list\nb_arg: args_from_file(enum) 10\nbehavior: yo\n"
                                   "b_arg: args_from_file(enum) 11\n"),
      list("-5300.0 6900.0\n-5230.0 6900.0\n", 2), yo(180.0, 5.0)};

  check_flight(files, deep_sea(), std::nullopt, request());

  EXPECT_THAT(files[0].messages, has("file_missing", Severity::warning, 0));
  EXPECT_THAT(files[0].messages, has("target_below_overdepth", Severity::error, 1));
  EXPECT_THAT(files[0].messages, has("waypoint_too_far", Severity::error, 1));
  std::vector<Document> listless{read_document("b.mi", "behavior: abend\nbehavior: goto_list\n")};
  check_flight(listless, deep_sea(), std::nullopt, request());
  EXPECT_THAT(listless[0].messages, has("nothing_dives", Severity::error, 0));
}

TEST(FlightCheck, HasNothingAgainstWhatTheWriterMakes) {
  MissionSetOptions options;
  options.vehicle = *vehicle::find_profile("slocum-g3-200");
  options.under_ice = UnderIce{{eastwards[0]}};
  const auto set = write_mission_set(support::plan_of(eastwards), options);
  ASSERT_TRUE(set.has_value());
  std::vector<Document> files;
  for (const MissionFile& file : set->files) {
    if (file.name != "goto_l98.ma") files.push_back(read_document(file.name, file.text));
  }

  check_flight(files, deep_sea(), eastwards[0], request());

  for (const Document& file : files) EXPECT_EQ(file.verdict(), Verdict::ok) << file.name;
}

}  // namespace
}  // namespace floeplan::mission::flight_check_test
