#include "engine/mission/writing/mission_set.hpp"

#include <gmock/gmock.h>

#include <set>
#include <sstream>

#include "engine/messages/sentence.hpp"
#include "engine/mission/document/document_text.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/flight_files.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission::mission_set_test {
namespace {

using support::plan_of;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

MissionSetOptions options_for(const char* vehicle) {
  MissionSetOptions options;
  options.vehicle = *vehicle::find_profile(vehicle);
  options.lists.origin.plan_id = "p-01";
  return options;
}

MissionSetOptions under_ice() {
  MissionSetOptions options = options_for("slocum-g3-200");
  options.under_ice = UnderIce{{{-53.5, 69.0}, {-53.25, 69.1}}};
  return options;
}

planning::Plan two_legs() { return plan_of({{-53.0, 69.0}, {-52.75, 69.0}, {-51.5, 69.175}}); }

std::vector<std::string> names_of(const MissionFiles& set) {
  std::vector<std::string> names;
  for (const MissionFile& file : set.files) names.push_back(file.name);
  return names;
}

Document read_of(const MissionFiles& set, const std::string& name) {
  const auto file = std::ranges::find(set.files, name, &MissionFile::name);
  return file == set.files.end() ? Document{} : read_document(name, file->text);
}

double value_of(const Document& document, const char* argument) {
  const Argument* found = document.behaviors.at(0).find(argument);
  return found == nullptr ? -9e9 : found->value;
}

/// Open water at every waypoint, and ice whose keels reach to 8.4 m on the way to the last one.
planning::Plan below_ice_between_waypoints() {
  planning::Plan plan = two_legs();
  plan.surfacing.emplace();
  plan.surfacing->longest_without = core::Seconds{1800.0};
  plan.surfacing->waypoints.resize(3);
  plan.surfacing->waypoints[1].leg_upper_turn = core::Metres{0.0};
  plan.surfacing->waypoints[2].leg_upper_turn = core::Metres{18.4};
  return plan;
}

struct OvershootRoom {
  const char* vehicle;
  double dive_depth_m;
  double target_m;
  double overdepth_m;
};

TEST(MissionSet, LeavesRoomForAnOvershootBetweenTheYoAndTheOverdepth) {
  for (const OvershootRoom& room :
       {OvershootRoom{"slocum-g3-30", 30.0, 27.0, 30.0}, OvershootRoom{"slocum-g3-200", 200.0, 180.0, 200.0},
        OvershootRoom{"slocum-g3-200", 100.0, 100.0, 115.0}, OvershootRoom{"slocum-g3-200", 12.0, 12.0, 15.0},
        OvershootRoom{"slocum-g3-1000", 1000.0, 980.0, 1000.0},
        OvershootRoom{"slocum-g3-1000", 100.0, 100.0, 120.0}}) {
    MissionSetOptions options = options_for(room.vehicle);
    options.vehicle.dive_depth = core::Metres{room.dive_depth_m};

    const auto set = write_mission_set(two_legs(), options);

    ASSERT_TRUE(set.has_value()) << room.vehicle;
    EXPECT_EQ(value_of(read_of(*set, "yo10.ma"), "d_target_depth"), room.target_m) << room.vehicle;
    EXPECT_EQ(value_of(read_of(*set, "plan.mi"), "overdepth"), room.overdepth_m) << room.vehicle;
  }
}

TEST(MissionSet, ComesUpRegularlyInOpenWaterAndNeverByTheClockBelowIce) {
  const auto shallow = write_mission_set(two_legs(), options_for("slocum-g3-200"));
  const auto deep = write_mission_set(two_legs(), options_for("slocum-g3-1000"));
  const auto below = write_mission_set(below_ice_between_waypoints(), under_ice());

  ASSERT_TRUE(shallow && deep && below);
  EXPECT_EQ(value_of(read_of(*shallow, "surfac14.ma"), "start_when"), 9.0);
  EXPECT_EQ(value_of(read_of(*shallow, "surfac14.ma"), "when_secs"), 10'800.0);
  EXPECT_EQ(value_of(read_of(*deep, "surfac14.ma"), "when_secs"), 21'600.0);
  for (const MissionFile& file : below->files) {
    if (!file.name.starts_with("surfac")) continue;
    EXPECT_NE(value_of(read_of(*below, file.name), "start_when"), 9.0) << file.name;
  }
}

TEST(MissionSet, ComesUpAsOftenAsThePlanWasAskedTo) {
  MissionSetOptions options = options_for("slocum-g3-200");
  options.surfacing_interval = core::Seconds{7200.0};

  const auto set = write_mission_set(two_legs(), options);

  ASSERT_TRUE(set.has_value());
  EXPECT_EQ(value_of(read_of(*set, "surfac10.ma"), "when_secs"), 7200.0);
  EXPECT_EQ(value_of(read_of(*set, "surfac14.ma"), "when_secs"), 7200.0);
}

TEST(MissionSet, SaysThatItKeepsNoPlannedSurfacingsBelowIce) {
  planning::Plan plan = below_ice_between_waypoints();
  plan.surfacing->surfacings.resize(3);

  const auto set = write_mission_set(plan, under_ice());

  ASSERT_TRUE(set.has_value());
  EXPECT_THAT(messages::sentences(set->messages),
              Contains(HasSubstr("3 planned surfacings are not in the files")));
}

TEST(MissionSet, HoldsEveryFileThatItsMissionAsksFor) {
  const auto set = write_mission_set(two_legs(), options_for("slocum-g3-200"));

  ASSERT_TRUE(set.has_value());
  EXPECT_THAT(names_of(*set),
              ElementsAre("plan.mi", "goto_l10.ma", "yo10.ma", "surfac10.ma", "surfac11.ma", "surfac12.ma",
                          "surfac13.ma", "surfac14.ma", "sample10.ma", "prepar10.ma"));
  const Document mission = read_of(*set, "plan.mi");
  std::vector<std::string> behaviors;
  for (const Behavior& behavior : mission.behaviors) behaviors.push_back(behavior.name);
  EXPECT_THAT(behaviors, ElementsAre("abend", "surface", "surface", "surface", "surface", "surface",
                                     "goto_list", "yo", "sample", "prepare_to_dive", "sensors_in"));
  for (const std::string& name : files_referenced(mission)) EXPECT_THAT(names_of(*set), Contains(name));
}

planning::Plan on_drives(planning::Plan plan, const vehicle::GliderProfile& vehicle,
                         const std::vector<vehicle::Drive>& drives) {
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    plan.waypoints[i].drive = drives[i - 1];
    plan.waypoints[i].speed_through_water =
        drives[i - 1] == vehicle::Drive::thruster ? vehicle.thruster->speed : vehicle.speed_through_water;
  }
  return plan;
}

constexpr vehicle::Drive thruster = vehicle::Drive::thruster;
constexpr vehicle::Drive buoyancy = vehicle::Drive::buoyancy;
const auto warns_of_thruster = Contains(HasSubstr("planned with the thruster"));

TEST(MissionSet, RunsTheThrusterAtThePowerOfTheVehicleWhereAllLegsAreOnIt) {
  const MissionSetOptions options = options_for("slocum-g3-200-thruster");

  const auto set = write_mission_set(on_drives(two_legs(), options.vehicle, {thruster, thruster}), options);

  ASSERT_TRUE(set.has_value());
  const Document yo = read_of(*set, "yo10.ma");
  for (const char* mode : {"d_use_thruster", "c_use_thruster"}) EXPECT_EQ(value_of(yo, mode), 4.0);
  for (const char* power : {"d_thruster_value", "c_thruster_value"})
    EXPECT_NEAR(value_of(yo, power), options.vehicle.thruster->power.value, 0.005);
  EXPECT_THAT(yo.messages, IsEmpty());
  EXPECT_THAT(messages::sentences(set->messages), Not(warns_of_thruster));
}

TEST(MissionSet, LeavesTheThrusterOffWhereOneYoCannotFlyThePlanOnIt) {
  const MissionSetOptions options = options_for("slocum-g3-200-thruster");
  MissionSetOptions stronger = options;
  stronger.vehicle.thruster->power = core::Watts{9.5};
  MissionSetOptions faster = options;
  faster.vehicle.thruster->speed = core::MetresPerSecond{0.6};
  const planning::Plan mixed = on_drives(two_legs(), options.vehicle, {buoyancy, thruster});
  const planning::Plan fast = on_drives(two_legs(), options.vehicle, {thruster, thruster});
  const planning::Plan slow = on_drives(two_legs(), options.vehicle, {buoyancy, buoyancy});

  const auto is_off = [](const tl::expected<MissionFiles, core::Violations>& set) {
    return value_of(read_of(set.value(), "yo10.ma"), "d_use_thruster") == -9e9;
  };

  for (const auto& set :
       {write_mission_set(mixed, options), write_mission_set(fast, stronger), write_mission_set(fast, faster),
        write_mission_set(fast, options_for("slocum-g3-200"))}) {
    ASSERT_TRUE(set.has_value());
    EXPECT_TRUE(is_off(set));
    EXPECT_THAT(messages::sentences(set->messages), warns_of_thruster);
  }
  EXPECT_TRUE(is_off(write_mission_set(slow, options)));
  EXPECT_THAT(messages::sentences(write_mission_set(slow, options)->messages), Not(warns_of_thruster));
}

TEST(MissionSet, LeavesRoomForWhatTheVehicleIsOffAtAFix) {
  planning::Plan plan = two_legs();
  plan.surfacing = planning::SurfacingPlan{};
  plan.surfacing->waypoints.resize(plan.waypoints.size());
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    plan.surfacing->waypoints[i].may_surface = true;
    plan.surfacing->waypoints[i].error_without_fix = core::Metres{2500.0 * static_cast<double>(i)};
  }

  MissionSetOptions options = options_for("slocum-g3-1000");
  options.surfacing_interval = plan.travel_time();
  const auto once = write_mission_set(plan, options);
  options.surfacing_interval = 0.2 * plan.travel_time();
  const auto often = write_mission_set(plan, options);

  ASSERT_TRUE(once && often);
  EXPECT_EQ(value_of(read_of(*once, "plan.mi"), "max_wpt_distance"), 91000.0)
      << "10 km more for 5 km of error";
  EXPECT_EQ(value_of(read_of(*often, "plan.mi"), "max_wpt_distance"), 83000.0)
      << "2 km more for 1 km of error since the last fix";
}

TEST(MissionSet, TakesDepthsAndDistancesFromVehicleAndPlan) {
  const auto set = write_mission_set(two_legs(), options_for("slocum-g3-1000"));

  ASSERT_TRUE(set.has_value());
  const Document mission = read_of(*set, "plan.mi");
  EXPECT_EQ(value_of(mission, "overdepth"), 1000.0);
  EXPECT_EQ(value_of(mission, "max_wpt_distance"), 81000.0) << "one and a half times 53.4 km";
  EXPECT_EQ(value_of(read_of(*set, "yo10.ma"), "d_target_depth"), 980.0);
  EXPECT_EQ(value_of(read_of(*set, "yo10.ma"), "d_target_altitude"), 20.0);
  EXPECT_EQ(value_of(read_of(*set, "yo10.ma"), "d_pitch_value"), -0.4538);
  EXPECT_EQ(value_of(read_of(*set, "yo10.ma"), "c_bpump_value"), 260.0);
  EXPECT_EQ(value_of(read_of(*set, "yo10.ma"), "c_target_depth"), 10.0);
  EXPECT_EQ(value_of(read_of(*set, "surfac10.ma"), "when_secs"), 28800.0);
  EXPECT_THAT(messages::sentences(set->messages), Contains(HasSubstr("turns at 980 m")));
}

TEST(MissionSet, UnderIceHoldsTheSafePlacesAndDoesNotComeUpAtWaypoints) {
  MissionSetOptions options = under_ice();
  options.under_ice->deepest_expected_iceberg = core::Metres{35.0};
  const auto set = write_mission_set(below_ice_between_waypoints(), options);

  ASSERT_TRUE(set.has_value());
  EXPECT_THAT(names_of(*set),
              ElementsAre("plan.mi", "goto_l10.ma", "yo10.ma", "surfac10.ma", "surfac11.ma", "surfac12.ma",
                          "sample10.ma", "prepar10.ma", "goto_l98.ma", "ice_10.mi"));
  const Document safe = read_of(*set, "goto_l98.ma");
  ASSERT_EQ(safe.waypoints.size(), 2U);
  EXPECT_DOUBLE_EQ(safe.waypoints[1].place.lon_deg, -53.25);
  for (const char* name : {"plan.mi", "ice_10.mi"}) {
    const Document settings = read_of(*set, name);
    const auto sensor = [&](const std::string& wanted) {
      const auto found = std::ranges::find(settings.sensors, wanted, &Argument::name);
      return found == settings.sensors.end() ? -9e9 : found->value;
    };
    EXPECT_EQ(sensor("u_expect_ice_near_surface"), 1.0);
    EXPECT_EQ(sensor("u_always_cop_tickle_hardware"), 1.0);
    EXPECT_EQ(sensor("u_lat_goto_l99"), 6900.0);
    EXPECT_EQ(sensor("u_lon_goto_l99"), -5330.0);
    EXPECT_EQ(sensor("u_max_expected_iceberg_depth"), 35.0);
  }
  EXPECT_THAT(messages::sentences(set->messages), Contains(HasSubstr("recov.mi")));
}

/// Safe places are for emergencies; only ice prevents surfacings on the route.
TEST(MissionSet, WithSafePlacesAndNoIceOnItsRouteSurfacesAsInOpenWater) {
  planning::Plan open = two_legs();
  open.surfacing.emplace();
  open.surfacing->waypoints.resize(open.waypoints.size());
  for (auto& state : open.surfacing->waypoints) state.leg_upper_turn = core::Metres{0.0};
  open.surfacing->surfacings.resize(3);
  open.datasets = {{.id = "ice-1", .kind = "ice", .name = "", .sha256 = ""}};
  planning::Plan unknown = open;
  unknown.datasets.clear();
  planning::Plan partly_unknown = open;
  partly_unknown.surfacing->longest_without = core::Seconds{1800.0};

  const auto without = write_mission_set(open, options_for("slocum-g3-200"));
  const auto with = write_mission_set(open, under_ice());
  const auto without_data = write_mission_set(unknown, under_ice());
  const auto with_gaps = write_mission_set(partly_unknown, under_ice());

  ASSERT_TRUE(without && with && without_data && with_gaps);
  for (const MissionFile& file : without->files) {
    if (!file.name.starts_with("surfac")) continue;
    EXPECT_THAT(with->files, Contains(file));
  }
  EXPECT_THAT(names_of(*with), Contains("goto_l98.ma"));
  EXPECT_THAT(messages::sentences(with->messages),
              Contains(HasSubstr("below no ice, so the mission surfaces at every waypoint and every 3 h")));
  EXPECT_THAT(messages::sentences(with->messages), Not(Contains(HasSubstr("not in the files"))));
  EXPECT_THAT(messages::sentences(without_data->messages), Contains(HasSubstr("without data on sea ice")));
  EXPECT_THAT(names_of(*with_gaps), Not(Contains("surfac13.ma"))) << "nothing is known of the ice somewhere";
}

TEST(MissionSet, UnderIceWaitsForContactLongerThanThePlanTakesAndTellsTheLongestList) {
  std::vector<geo::LonLat> places;
  for (int i = 0; i <= 40; ++i) places.push_back({-53.0 + 0.1 * i, 69.0});
  MissionSetOptions options = under_ice();
  options.lists.max_waypoints = 20;  // of 20 h, one hour for each leg

  planning::Plan plan = support::plan_of(places);
  plan.surfacing.emplace();
  plan.surfacing->longest_without = core::Seconds{1800.0};
  plan.surfacing->waypoints.resize(places.size());
  for (auto& state : plan.surfacing->waypoints) state.leg_upper_turn = core::Metres{0.0};
  plan.surfacing->waypoints[7].leg_upper_turn = core::Metres{18.4};

  const auto set = write_mission_set(plan, options);

  ASSERT_TRUE(set.has_value());
  EXPECT_EQ(value_of(read_of(*set, "surfac10.ma"), "when_secs"), 50.0 * 3600.0);
  EXPECT_THAT(messages::sentences(set->messages),
              Contains(HasSubstr("a list takes 20 h below ice without contact")));
}

TEST(MissionSet, OfAPlanUnderAnIcebergTurnsBelowItsKeelAndNeedsTheRulesUnderIce) {
  planning::Plan plan = two_legs();
  plan.passed_under = {
      {"B-17", {{40.0}, true, {50.0}, {69.5}}, plan.departure, plan.arrival - core::Seconds{600.0}}};

  const auto in_the_open = write_mission_set(plan, options_for("slocum-g3-200"));
  const auto below = write_mission_set(plan, under_ice());

  ASSERT_FALSE(in_the_open.has_value());
  EXPECT_THAT(in_the_open.error(), Contains(Field(&core::Violation::field, "/under_ice")));
  ASSERT_TRUE(below.has_value());
  EXPECT_EQ(value_of(read_of(*below, "yo10.ma"), "c_target_depth"), 70.0);
  EXPECT_THAT(messages::sentences(below->messages), Contains(HasSubstr("under iceberg B-17")));
}

TEST(MissionSet, OfAPlanBelowIceBetweenItsWaypointsTurnsBelowTheKeelsAndNeedsTheRulesUnderIce) {
  const planning::Plan plan = below_ice_between_waypoints();

  const auto in_the_open = write_mission_set(plan, options_for("slocum-g3-200"));
  const auto below = write_mission_set(plan, under_ice());

  ASSERT_FALSE(in_the_open.has_value());
  EXPECT_THAT(in_the_open.error(), ElementsAre(Field(&core::Violation::field, "/under_ice")));
  ASSERT_TRUE(below.has_value());
  EXPECT_EQ(value_of(read_of(*below, "yo10.ma"), "c_target_depth"), 19.0);
  EXPECT_THAT(names_of(*below), Not(Contains("surfac13.ma"))) << "no surfacing at waypoints";
  EXPECT_THAT(messages::sentences(below->messages),
              Contains(HasSubstr(
                  "below ice or icebergs on the legs to these waypoints: 2. Request no surfacing there, and "
                  "set the upper turn of the yo to 19 m or deeper")));
}

TEST(MissionSet, NeverClimbsAboveTheDeepestTurnOfItsPlan) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    planning::Plan plan = two_legs();
    plan.surfacing.emplace();
    plan.surfacing->longest_without = core::Seconds{600.0};
    plan.surfacing->waypoints.resize(3);
    double deepest_m = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      planning::SurfacingState& state = plan.surfacing->waypoints[i];
      const double turn_m = support::uniform_int(rng, 0, 1) == 0 ? 0.0 : support::uniform(rng, 0.1, 150.0);
      const bool at_waypoint = support::uniform_int(rng, 0, 2) == 0;
      if (at_waypoint) state.least_upper_turn = core::Metres{turn_m};
      if (i > 0) state.leg_upper_turn = core::Metres{turn_m};
      if (at_waypoint || i > 0) deepest_m = std::max(deepest_m, turn_m);
    }

    const auto set = write_mission_set(plan, under_ice());

    EXPECT_EQ(write_mission_set(plan, options_for("slocum-g3-200")).has_value(), deepest_m == 0.0);
    ASSERT_TRUE(set.has_value());
    EXPECT_GE(value_of(read_of(*set, "yo10.ma"), "c_target_depth"), deepest_m);
  });
}

TEST(MissionSet, SaysWhereThereIsNowhereToSurface) {
  planning::Plan plan = plan_of({{-53.0, 69.0}, {-52.75, 69.0}, {-51.5, 69.175}, {-51.0, 69.2}});
  plan.surfacing.emplace();
  plan.surfacing->longest_without = core::Seconds{7200.0};
  plan.surfacing->waypoints.resize(4);
  for (const std::size_t i : {1U, 2U}) {
    plan.surfacing->waypoints[i] = {.may_surface = false,
                                    .since_surfacing = core::Seconds{3600.0},
                                    .position_error = {},
                                    .least_upper_turn = {18.0},
                                    .leg_upper_turn = core::Metres{18.0}};
  }
  plan.surfacing->waypoints[2].since_surfacing = core::Seconds{1200.0};  // there was a lead on the way
  plan.surfacing->waypoints[3].leg_upper_turn = core::Metres{0.0};

  const auto set = write_mission_set(plan, under_ice());

  ASSERT_TRUE(set.has_value());
  EXPECT_THAT(messages::sentences(set->messages),
              Contains(HasSubstr("the vehicle has no place to surface: 1. ")));
  EXPECT_THAT(messages::sentences(set->messages), Contains(HasSubstr("legs to these waypoints: 1 to 2")));
}

TEST(MissionSet, IsRefusedForAPlanThatEndsBelowIce) {
  planning::Plan plan = below_ice_between_waypoints();
  plan.surfacing->waypoints[2].may_surface = false;
  plan.surfacing->waypoints[2].least_upper_turn = core::Metres{18.4};

  const auto set = write_mission_set(plan, under_ice());

  ASSERT_FALSE(set.has_value());
  EXPECT_THAT(set.error(), ElementsAre(Field(&core::Violation::field, "/waypoints/2")));
}

TEST(MissionSet, IsRefusedForAPlanThatDoesNotTellHowDeepItsDivesTurnBelowIce) {
  planning::Plan plan = below_ice_between_waypoints();
  for (auto& state : plan.surfacing->waypoints) state.leg_upper_turn.reset();

  const auto set = write_mission_set(plan, under_ice());
  ASSERT_FALSE(set.has_value());
  EXPECT_THAT(set.error(), ElementsAre(Field(&core::Violation::field, "/plan_id")));

  plan.surfacing->longest_without = core::Seconds{0.0};  // open water all the way
  EXPECT_TRUE(write_mission_set(plan, options_for("slocum-g3-200")).has_value());
}

TEST(MissionSet, IsRefusedWhereItsDivesHaveNoRoomBelowTheIce) {
  planning::Plan plan = below_ice_between_waypoints();
  plan.surfacing->waypoints[2].leg_upper_turn = core::Metres{180.0};

  const auto set = write_mission_set(plan, under_ice());

  ASSERT_FALSE(set.has_value());
  EXPECT_THAT(set.error(), ElementsAre(Field(&core::Violation::field, "/dive_depth_m")));
}

/// Water of 300 m but for one shallower place of the leg to `waypoint`.
std::vector<std::optional<Shoal>> shoal_on_leg(const planning::Plan& plan, std::size_t waypoint,
                                               double bed_m) {
  std::vector<std::optional<Shoal>> shoals(plan.waypoints.size());
  for (std::size_t i = 1; i < shoals.size(); ++i) shoals[i] = Shoal{{300.0}, plan.waypoints[i].place, i};
  shoals[waypoint] = Shoal{{bed_m}, {-52.8, 69.0}, waypoint};
  return shoals;
}

TEST(MissionSet, IsRefusedOverAShoalThatItsYoIsTooDeepFor) {
  planning::Plan plan = below_ice_between_waypoints();
  MissionSetOptions options = under_ice();
  options.shoals = shoal_on_leg(plan, 1, 30.9);  // 19 m, a tooth of 2 m and a margin of 10 m are 31 m

  const auto over_a_bank = write_mission_set(plan, options);
  options.shoals = shoal_on_leg(plan, 1, 31.0);
  const auto over_enough = write_mission_set(plan, options);
  plan.waypoints[1].depth = core::Metres{30.9};
  options.shoals.clear();
  const auto by_the_plan = write_mission_set(plan, options);

  ASSERT_FALSE(over_a_bank.has_value());
  EXPECT_THAT(
      over_a_bank.error(),
      ElementsAre(
          AllOf(Field(&core::Violation::field, "/waypoints"),
                Field(&core::Violation::rule,
                      HasSubstr("water of only 30 m at -52.8000, 69.0000, before waypoint 1. The mission "
                                "has one yo for all legs. Its upper turn must be no shallower than 19 m")))));
  ASSERT_TRUE(over_enough.has_value());
  EXPECT_THAT(messages::sentences(over_enough->messages), Not(Contains(HasSubstr("sea bed is unknown"))));
  ASSERT_FALSE(by_the_plan.has_value());
}

TEST(MissionSet, SaysThatNothingIsKnownOfTheBedBelowIce) {
  const planning::Plan plan = below_ice_between_waypoints();
  MissionSetOptions options = under_ice();
  EXPECT_THAT(messages::sentences(write_mission_set(plan, options)->messages),
              Contains(HasSubstr("sea bed is unknown")));

  options.shoals = shoal_on_leg(plan, 1, 300.0);
  options.shoals[2].reset();
  EXPECT_THAT(messages::sentences(write_mission_set(plan, options)->messages),
              Contains(HasSubstr("sea bed is unknown")));
}

TEST(MissionSet, IsRefusedForDivesShoalerThanItsYoClimbs) {
  MissionSetOptions options = options_for("slocum-g3-200");
  options.vehicle.climb_to = core::Metres{0.0};
  options.vehicle.dive_depth = core::Metres{4.0};  // the least climb is 3 m, and the lowest tooth 2 m

  const auto set = write_mission_set(two_legs(), options);

  ASSERT_FALSE(set.has_value());
  EXPECT_THAT(set.error(), Contains(Field(&core::Violation::field, "/dive_depth_m")));
}

TEST(MissionSet, OfAnyPlanTurnsAboveTheBedEverywhereOnTheWay) {
  int written = 0;
  int refused = 0;
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    planning::Plan plan = below_ice_between_waypoints();
    plan.surfacing->waypoints[2].leg_upper_turn = core::Metres{support::uniform(rng, 0.0, 120.0)};
    MissionSetOptions options = under_ice();
    options.vehicle.altimeter_margin = core::Metres{support::uniform(rng, 0.0, 20.0)};
    double least_m = 1e9;
    options.shoals.resize(3);
    for (const std::size_t leg : {1U, 2U}) {
      const double bed_m = support::uniform(rng, 20.0, 250.0);
      least_m = std::min(least_m, bed_m);
      options.shoals[leg] = Shoal{{bed_m}, plan.waypoints[leg].place, leg};
    }

    const auto set = write_mission_set(plan, options);

    if (!set) {
      ++refused;
      EXPECT_LT(least_m, plan.surfacing->waypoints[2].leg_upper_turn->value + 1.0 + 2.0 +
                             options.vehicle.altimeter_margin.value + 1.0)
          << set.error().front().rule;
      return;
    }
    ++written;
    const Document yo = read_of(*set, "yo10.ma");
    EXPECT_LE(value_of(yo, "c_target_depth") + 2.0 + value_of(yo, "d_target_altitude"), least_m);
  });
  EXPECT_GT(written, 30);
  EXPECT_GT(refused, 30);
}

TEST(MissionSet, ExpectsIcebergsAsDeepAsWhatThePlanPassesBelow) {
  const auto expected_depth = [](const planning::Plan& plan, const MissionSetOptions& options) {
    const auto set = write_mission_set(plan, options);
    if (!set) return -1.0;
    const Document settings = read_of(*set, "ice_10.mi");
    return std::ranges::find(settings.sensors, "u_max_expected_iceberg_depth", &Argument::name)->value;
  };
  planning::Plan thin_ice = below_ice_between_waypoints();
  planning::Plan thick_ice = below_ice_between_waypoints();
  thick_ice.surfacing->waypoints[2].leg_upper_turn = core::Metres{58.0};
  planning::Plan iceberg = below_ice_between_waypoints();
  iceberg.passed_under = {{"B-17",
                           {{80.0}, true, {100.0}, {120.0}},
                           iceberg.arrival - core::Seconds{1800.0},
                           iceberg.arrival - core::Seconds{900.0}}};
  iceberg.surfacing->waypoints[2].leg_upper_turn = core::Metres{120.0};
  planning::Plan iceberg_in_ice = iceberg;
  iceberg_in_ice.datasets = {{.id = "ice-1", .kind = "ice", .name = "", .sha256 = ""}};

  EXPECT_EQ(expected_depth(thin_ice, under_ice()), 20.0) << "the stock settings";
  EXPECT_EQ(expected_depth(thick_ice, under_ice()), 48.0);
  EXPECT_EQ(expected_depth(iceberg, under_ice()), 100.0);
  EXPECT_EQ(expected_depth(iceberg_in_ice, under_ice()), 110.0) << "the turn may be that of ice";

  MissionSetOptions options = under_ice();
  options.under_ice->deepest_expected_iceberg = core::Metres{60.0};
  EXPECT_EQ(expected_depth(thick_ice, options), 60.0);
  options.under_ice->deepest_expected_iceberg = core::Metres{47.0};
  EXPECT_THAT(write_mission_set(thick_ice, options).error(),
              ElementsAre(Field(&core::Violation::field, "/iceberg_depth_m")));
}

TEST(MissionSet, TimesItsHoldsByTheVehicleAndItsSurfacings) {
  planning::Plan plan = two_legs();
  plan.waypoints[1].wait = core::Seconds{3.0 * 3600.0};
  MissionSetOptions options = options_for("slocum-g3-200");

  const auto set = write_mission_set(plan, options);

  ASSERT_TRUE(set.has_value());
  EXPECT_THAT(set->files, Contains(Field(&MissionFile::name, "goto_l12.ma")));
  const auto lists = write_goto_lists(plan, list_options(plan, options));
  ASSERT_TRUE(lists.has_value());
  for (const MissionFile& list : lists->files) EXPECT_THAT(set->files, Contains(list));
}

TEST(MissionSet, RefusesEveryBadOptionAtOnce) {
  MissionSetOptions options = under_ice();
  options.name = "Too Long Name";
  options.firmware = {6, 0};
  options.under_ice->safe_places = {{0.0, 95.0}};
  options.under_ice->deepest_expected_iceberg = core::Metres{500.0};
  options.lists.first_number = 96;
  const auto set = write_mission_set(two_legs(), options);

  ASSERT_FALSE(set.has_value());
  for (const char* field : {"/mission", "/firmware", "/safe/0", "/iceberg_depth_m", "/number"})
    EXPECT_THAT(set.error(), Contains(Field(&core::Violation::field, field))) << field;
}

TEST(MissionSet, NeverReplacesAStockMission) {
  MissionSetOptions options = options_for("slocum-g3-200");
  for (const char* name : {"recov", "stock", "autoexec", "ice"}) {
    options.name = name;
    EXPECT_FALSE(write_mission_set(two_legs(), options).has_value()) << name;
  }
}

TEST(MissionSet, NeverWritesAFactorySettingOrWhatANameSmugglesIn) {
  MissionSetOptions options = under_ice();
  options.lists.origin.plan_name = "x\nsensor: f_max_working_depth(m) 2000\n";
  options.lists.origin.written_by = "y\r\nbehavior: yo";
  const auto set = write_mission_set(below_ice_between_waypoints(), options);

  ASSERT_TRUE(set.has_value());
  const std::set<std::string> allowed{
      "u_use_current_correction",     "c_science_all_on_enabled", "u_expect_ice_near_surface",
      "u_always_cop_tickle_hardware", "u_lat_goto_l99",           "u_lon_goto_l99",
      "u_max_expected_iceberg_depth"};
  for (const MissionFile& file : set->files) {
    for (const Argument& sensor : read_document(file.name, file.text).sensors)
      EXPECT_TRUE(allowed.contains(sensor.name)) << file.name << ": " << sensor.name;
  }
  EXPECT_EQ(read_of(*set, "plan.mi").behaviors.size(), 9U);
}

TEST(MissionSet, IsTheSameEveryTime) {
  const auto once = write_mission_set(two_legs(), under_ice());
  const auto again = write_mission_set(two_legs(), under_ice());

  EXPECT_EQ(once->files, again->files);
}

void expect_text_of_a_vehicle(const MissionFile& file) {
  EXPECT_LE(file.name.find('.'), 8U) << file.name;
  std::istringstream lines{file.text};
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LT(line.size(), 100U) << line;
    EXPECT_TRUE(std::ranges::all_of(line, [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; }))
        << line;
  }
}

TEST(MissionSet, OfAnyPlanIsAcceptedReadBackAndWrittenAgainAlike) {
  support::for_each_seed(150, [](std::mt19937_64& rng) {
    const auto places = support::random_places(rng, 2, 40);
    const auto profiles = vehicle::known_profiles();
    MissionSetOptions options;
    options.vehicle = profiles[static_cast<std::size_t>(
        support::uniform_int(rng, 0, static_cast<int>(profiles.size()) - 1))];
    options.vehicle.dive_depth.value = support::uniform(rng, 25.0, options.vehicle.depth_rating.value);
    options.lists.first_number = support::uniform_int(rng, 0, 50);
    options.lists.max_waypoints = support::uniform_int(rng, 1, 12);
    for (int i = support::uniform_int(rng, 0, 30); i > 0; --i)
      options.lists.origin.plan_name += static_cast<char>(support::uniform_int(rng, 0, 255));
    if (support::uniform_int(rng, 0, 1) == 1) options.under_ice = UnderIce{support::random_places(rng, 1, 8)};

    const auto set = write_mission_set(plan_of(places), options);

    ASSERT_TRUE(set.has_value());
    std::vector<geo::LonLat> read;
    for (const MissionFile& file : set->files) {
      expect_text_of_a_vehicle(file);
      const Document document = read_document(file.name, file.text);
      ASSERT_EQ(document.verdict(), Verdict::ok) << file.name << document.messages.front().text << file.text;
      EXPECT_EQ(write_document(document), file.text);
      if (file.name == "goto_l98.ma") continue;
      for (const WaypointRow& row : document.waypoints) read.push_back(row.place);
    }
    ASSERT_EQ(read.size(), places.size() - 1);
    for (std::size_t i = 0; i < read.size(); ++i)
      EXPECT_LT(geo::geodesic_between(places[i + 1], read[i]).length.value, 0.14) << "0.1 m on each axis";
  });
}

}  // namespace
}  // namespace floeplan::mission::mission_set_test
