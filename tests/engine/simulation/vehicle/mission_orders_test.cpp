#include "engine/simulation/vehicle/mission_orders.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/mission_set.hpp"
#include "tests/engine/mission/random_plan.hpp"
#include "tests/engine/simulation/flown.hpp"

namespace floeplan::simulation::mission_orders_test {
namespace {

using support::plan_of;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<mission::Document> documents_of(const mission::MissionFiles& files) {
  std::vector<mission::Document> documents;
  for (const mission::MissionFile& file : files.files)
    documents.push_back(mission::read_document(file.name, file.text));
  return documents;
}

mission::MissionFiles exported(const char* vehicle, const std::vector<geo::LonLat>& places) {
  mission::MissionSetOptions options;
  options.vehicle = *vehicle::find_profile(vehicle);
  return mission::write_mission_set(plan_of(places), options).value();
}

TEST(MissionOrders, AreThoseOfTheExportedFiles) {
  const auto files = exported("slocum-g3-200", {{-52.0, 47.5}, {-51.95, 47.5}, {-51.9, 47.55}});

  const auto orders = read_orders(documents_of(files), *vehicle::find_profile("slocum-g3-200"));

  ASSERT_TRUE(orders.has_value());
  ASSERT_THAT(orders->lists, SizeIs(1));
  EXPECT_THAT(orders->lists.front().waypoints, SizeIs(2));
  EXPECT_EQ(orders->lists.front().rows.legs, -2);
  EXPECT_EQ(orders->yo.dive.depth, core::Metres{180.0});
  EXPECT_NEAR(orders->yo.dive.pitch_rad, -0.4538, 1e-9);
  EXPECT_NEAR(orders->yo.climb.buoyancy_m3, 230e-6, 1e-12);
  EXPECT_THAT(orders->surfaces, SizeIs(5));
  EXPECT_TRUE(orders->surfaces[1].ends_mission);
  EXPECT_EQ(orders->overdepth, core::Metres{200.0});
  ASSERT_EQ(orders->notes.size(), 1U);
  EXPECT_THAT(orders->notes.front(), HasSubstr("does not switch sensors on and off"));
}

TEST(MissionOrders, FlyToTheLastWaypointOfTheExportedFiles) {
  auto vehicle = *vehicle::find_profile("slocum-g3-200");
  const auto files = exported("slocum-g3-200", {{-52.0, 47.5}, {-51.95, 47.5}, {-51.93, 47.52}});
  const auto orders = read_orders(documents_of(files), vehicle);
  ASSERT_TRUE(orders.has_value());
  const World world = support::uniform_water(0.03, 0.04);
  BareVehicle bare;

  const FlightRecord record = fly({.world = world,
                                   .orders = *orders,
                                   .vehicle = vehicle,
                                   .start = {-52.0, 47.5},
                                   .departure = support::flight_start},
                                  bare);

  EXPECT_EQ(record.end, FlightEnd::arrived) << record.end_reason;
  const Vector goal = world.to_frame({-51.93, 47.52});
  const Vector end = record.track.back().position;
  EXPECT_LT(std::hypot(goal.east - end.east, goal.north - end.north), 1000.0);
}

TEST(MissionOrders, FlyEveryListOfAPlanThatIsLongerThanOne) {
  std::vector<geo::LonLat> places;
  for (int i = 0; i <= 18; ++i) places.push_back({-52.0 + 0.02 * i, 47.5});
  const auto vehicle = *vehicle::find_profile("slocum-g3-200");
  const auto files = exported("slocum-g3-200", places);
  auto documents = documents_of(files);
  const auto last = std::ranges::find(files.files, "goto_l12.ma", &mission::MissionFile::name);
  ASSERT_NE(last, files.files.end());
  documents.push_back(mission::read_document("goto_l14.ma", last->text));  // none is numbered 13

  const auto orders = read_orders(documents, vehicle);

  ASSERT_TRUE(orders.has_value());
  EXPECT_THAT(orders->lists,
              ElementsAre(Field(&GotoOrders::waypoints, SizeIs(8)), Field(&GotoOrders::waypoints, SizeIs(8)),
                          Field(&GotoOrders::waypoints, SizeIs(2))));
  EXPECT_NEAR(orders->lists.back().waypoints.back().lon_deg, places.back().lon_deg, 1e-4);
  EXPECT_THAT(orders->notes, Contains(HasSubstr("at the end of the one before")));
}

TEST(MissionOrders, RefuseFilesForADeeperVehicle) {
  const auto files = exported("slocum-g3-1000", {{-52.0, 47.5}, {-51.95, 47.5}});

  const auto orders = read_orders(documents_of(files), *vehicle::find_profile("slocum-g3-200"));

  ASSERT_FALSE(orders.has_value());
  EXPECT_THAT(orders.error(),
              Contains(Field(&core::Violation::rule, HasSubstr("the files were written"))));
}

TEST(MissionOrders, RefuseEveryFaultAtOnce) {
  auto documents = documents_of(exported("slocum-g3-200", {{-52.0, 47.5}, {-51.95, 47.5}}));
  std::erase_if(documents,
                [](const mission::Document& d) { return d.name == "surfac11.ma" || d.name == "yo10.ma"; });

  const auto orders = read_orders(documents, *vehicle::find_profile("slocum-g3-200"));

  ASSERT_FALSE(orders.has_value());
  EXPECT_THAT(orders.error(), SizeIs(2));
}

TEST(MissionOrders, RefuseADocumentThatIsBrokenAndOneOfAnotherMake) {
  const std::vector<mission::Document> broken{
      mission::read_document("goto_l10.ma", "behavior_name=goto_list\n"),
      mission::read_document("targets", "/ none\nA lat=4730 lon=-5200 radius=100 goto=A\n")};

  const auto orders = read_orders(broken, *vehicle::find_profile("slocum-g3-200"));

  ASSERT_FALSE(orders.has_value());
  EXPECT_GE(orders.error().size(), 2U);
  EXPECT_THAT(orders.error(), Contains(Field(&core::Violation::rule, HasSubstr("Seaglider"))));
}

TEST(MissionOrders, RefuseADepthThatAnotherProgramOnBoardSets) {
  const std::vector<mission::Document> documents{
      mission::read_document(
          "goto_l10.ma",
          "behavior_name=goto_list\n<start:b_arg>\n b_arg: num_waypoints(nodim) 1\n<end:b_arg>\n"
          "<start:waypoints>\n-5157.0000 4730.0000\n<end:waypoints>\n"),
      mission::read_document(
          "yo10.ma", "behavior_name=yo\n<start:b_arg>\n b_arg: d_target_depth(m) 1000000\n<end:b_arg>\n")};

  const auto orders = read_orders(documents, *vehicle::find_profile("slocum-g3-200"));

  ASSERT_FALSE(orders.has_value());
  EXPECT_THAT(orders.error(), Contains(Field(&core::Violation::rule, HasSubstr("the depth itself"))));
}

TEST(MissionOrders, RefuseCountsThatNoVehicleFlies) {
  for (const char* legs : {"0", "-3", "1000000000", "1e300"}) {
    const auto list = mission::read_document(
        "goto_l10.ma",
        std::string{"behavior_name=goto_list\n<start:b_arg>\n b_arg: num_legs_to_run(nodim) "} + legs +
            "\n b_arg: num_waypoints(nodim) 1\n<end:b_arg>\n<start:waypoints>\n"
            "-5157.0000 4730.0000\n<end:waypoints>\n");

    EXPECT_FALSE(read_orders(std::vector{list}, *vehicle::find_profile("slocum-g3-200")).has_value()) << legs;
  }
}

TEST(MissionOrders, FillUpAListAloneFromTheVehicle) {
  const auto list = mission::read_document(
      "goto_l10.ma",
      "behavior_name=goto_list\n<start:b_arg>\n b_arg: num_legs_to_run(nodim) -2\n b_arg: initial_wpt(enum) "
      "0\n"
      " b_arg: list_when_wpt_dist(m) 100\n b_arg: num_waypoints(nodim) 1\n<end:b_arg>\n<start:waypoints>\n"
      "-5157.0000 4730.0000\n<end:waypoints>\n");

  const auto orders = read_orders(std::vector{list}, *vehicle::find_profile("slocum-g3-200"));

  ASSERT_TRUE(orders.has_value());
  EXPECT_EQ(orders->yo.dive.depth, core::Metres{200.0});
  EXPECT_THAT(orders->surfaces, SizeIs(1));
  EXPECT_THAT(orders->notes, SizeIs(2));
}

}  // namespace
}  // namespace floeplan::simulation::mission_orders_test
