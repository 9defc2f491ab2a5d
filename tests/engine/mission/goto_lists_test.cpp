#include "engine/mission/goto_lists.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "tests/engine/mission/list_reader.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission {
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
  for (const geo::LonLat place : places) plan.waypoints.emplace_back().place = place;
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
  EXPECT_THAT(lists->warnings, IsEmpty());
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
  EXPECT_THAT(lists->warnings, ElementsAre(HasSubstr("send the next one")));
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
  EXPECT_THAT(lists->warnings, IsEmpty());
}

TEST(GotoLists, WarnWhenALegIsTooShortForAnyRadius) {
  const auto lists = write_goto_lists(plan_through({{0.0, 69.0}, {1.0, 69.0}, {1.0, 69.0001}}), {});

  ASSERT_TRUE(lists.has_value());
  EXPECT_EQ(support::read_goto_list(lists->files.at(0).text).b_args.at("list_when_wpt_dist(m)"), 10.0);
  EXPECT_THAT(lists->warnings, ElementsAre(HasSubstr("may skip a waypoint")));
}

TEST(GotoLists, WarnWhenTheGivenRadiusIsLargerThanAClearance) {
  planning::Plan plan = plan_eastwards(3);
  plan.clearances.iceberg = core::Metres{400.0};
  plan.clearances.land = core::Metres{5000.0};

  const auto lists = write_goto_lists(plan, {.radius = core::Metres{450.0}});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(lists->warnings, ElementsAre(HasSubstr("an iceberg at 400 m")));
}

TEST(GotoLists, WarnOfLongLegsPolesAndLongLists) {
  const auto lists =
      write_goto_lists(plan_through({{0.0, 83.0}, {0.0, 83.5}, {0.0, 85.0}}), {.max_waypoints = 12});

  ASSERT_TRUE(lists.has_value());
  EXPECT_THAT(lists->warnings,
              ElementsAre(HasSubstr("the vendor documents 8"), HasSubstr("leg to waypoint 2 is 168 km"),
                          HasSubstr("beyond 84 N")));
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
}  // namespace floeplan::mission
