#include "engine/vehicle/glider_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

namespace floeplan::vehicle::glider_profile_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;

TEST(GliderProfile, OfEveryKnownVehicleIsValid) {
  ASSERT_FALSE(known_profiles().empty());
  for (const GliderProfile& profile : known_profiles()) {
    EXPECT_TRUE(profile.violations().empty()) << profile.name;
    EXPECT_FALSE(profile.title.empty()) << profile.name;
    EXPECT_GT(profile.minimum_working_depth, profile.altimeter_margin) << profile.name;
  }
}

TEST(GliderProfile, HasANameOfItsOwn) {
  std::set<std::string> names;
  for (const GliderProfile& profile : known_profiles()) {
    EXPECT_TRUE(names.insert(profile.name).second) << profile.name;
  }
}

TEST(GliderProfile, IsFoundByItsName) {
  for (const GliderProfile& profile : known_profiles()) {
    const auto found = find_profile(profile.name);

    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->title, profile.title);
    EXPECT_EQ(found->dive_depth, profile.dive_depth);
  }
}

TEST(GliderProfile, IsNotFoundByAnotherName) {
  EXPECT_FALSE(find_profile("submarine").has_value());
  EXPECT_FALSE(find_profile("").has_value());
}

TEST(GliderProfile, IsFoundForShallowerWaterAmongThoseOfItsMake) {
  const auto names = [](const char* name) {
    std::vector<std::string> result;
    for (const GliderProfile& profile : profiles_for_shallower_water(name)) result.push_back(profile.name);
    return result;
  };

  EXPECT_EQ(names("slocum-g3-1000"), (std::vector<std::string>{"slocum-g3-200", "slocum-g3-30"}));
  EXPECT_EQ(names("slocum-g2-200-thruster"), (std::vector<std::string>{"slocum-g2-30-thruster"}));
  EXPECT_TRUE(names("slocum-g3-30").empty());
  EXPECT_TRUE(names("submarine").empty());
}

TEST(GliderProfile, TakesTheLimitsThemselves) {
  GliderProfile profile;
  profile.speed_through_water = {0.05};
  profile.climb_to = {0.0};
  profile.dive_depth = {2.0};
  EXPECT_TRUE(profile.violations().empty());

  profile.speed_through_water = {5.0};
  profile.dive_depth = profile.depth_rating;
  EXPECT_TRUE(profile.violations().empty());
}

struct Fault {
  std::string title;
  void (*spoil)(GliderProfile&);
  std::string field;
};

class SpoiltProfile : public testing::TestWithParam<Fault> {};

TEST_P(SpoiltProfile, NamesTheFieldAtFault) {
  GliderProfile profile = known_profiles().front();
  GetParam().spoil(profile);

  EXPECT_THAT(profile.violations(), ElementsAre(Field(&core::Violation::field, GetParam().field)));
}

INSTANTIATE_TEST_SUITE_P(
    EachField, SpoiltProfile,
    testing::Values(
        Fault{"TooSlow", [](GliderProfile& p) { p.speed_through_water = {0.049}; }, "/speed_m_s"},
        Fault{"TooFast", [](GliderProfile& p) { p.speed_through_water = {5.01}; }, "/speed_m_s"},
        Fault{"SpeedNotANumber",
              [](GliderProfile& p) { p.speed_through_water = {std::numeric_limits<double>::quiet_NaN()}; },
              "/speed_m_s"},
        Fault{"DivesNoDeeperThanItClimbs", [](GliderProfile& p) { p.dive_depth = {6.9}; }, "/climb_to_m"},
        Fault{"ClimbsOutOfTheWater", [](GliderProfile& p) { p.climb_to = {-1.0}; }, "/climb_to_m"},
        Fault{"DivesBelowItsRating", [](GliderProfile& p) { p.dive_depth = {200.1}; }, "/dive_depth_m"},
        Fault{"RatedBeyondTheDeepestSea", [](GliderProfile& p) { p.depth_rating = {12'000.0}; },
              "/vehicle/depth_rating_m"},
        Fault{"NegativeWorkingDepth", [](GliderProfile& p) { p.minimum_working_depth = {-1.0}; },
              "/vehicle/minimum_working_depth_m"},
        Fault{"NegativeAltimeterMargin", [](GliderProfile& p) { p.altimeter_margin = {-1.0}; },
              "/altimeter_margin_m"},
        Fault{"TakesNoWaypoint", [](GliderProfile& p) { p.max_waypoints_per_list = 0; },
              "/vehicle/max_waypoints_per_list"},
        Fault{"TooFlat", [](GliderProfile& p) { p.pitch = {0.1}; }, "/pitch_deg"},
        Fault{"PumpsNothing", [](GliderProfile& p) { p.buoyancy = {0.0}; }, "/vehicle/buoyancy_cm3"},
        Fault{"PumpBeatsNature", [](GliderProfile& p) { p.energy.pump_efficiency = 1.1; },
              "/vehicle/pump_efficiency"},
        Fault{"NegativeBattery", [](GliderProfile& p) { p.energy.battery = {-1.0}; }, "/battery_j"},
        Fault{"OverchargedBattery", [](GliderProfile& p) { p.energy.battery_start_share = 1.1; },
              "/battery_start_share"},
        Fault{"NegativeHotelLoad", [](GliderProfile& p) { p.energy.hotel = {-0.1}; }, "/vehicle/hotel_w"},
        Fault{"IdleThruster", [](GliderProfile& p) { p.thruster = Thruster{.speed = {0.0}}; },
              "/vehicle/thruster/speed_m_s"}),
    [](const auto& fault) { return fault.param.title; });

TEST(GliderProfile, TellsAllFaultsAtOnce) {
  GliderProfile profile;
  profile.speed_through_water = {0.0};
  profile.dive_depth = {0.0};
  profile.depth_rating = {0.0};

  const core::Violations found = profile.violations();

  for (const char* field : {"/speed_m_s", "/dive_depth_m", "/climb_to_m", "/vehicle/depth_rating_m"}) {
    EXPECT_THAT(found, Contains(Field(&core::Violation::field, field)));
  }
}

TEST(GliderProfile, KnowsEveryDepthClassOfBothGenerationsWithAndWithoutThruster) {
  for (const char* base : {"slocum-g3-200", "slocum-g3-1000", "slocum-g3-30", "slocum-g2-200",
                           "slocum-g2-1000", "slocum-g2-30"}) {
    const auto plain = find_profile(base);
    const auto driven = find_profile(std::string{base} + "-thruster");

    ASSERT_TRUE(plain && driven) << base;
    EXPECT_FALSE(plain->thruster.has_value());
    ASSERT_TRUE(driven->thruster.has_value());
    EXPECT_GT(driven->thruster->speed, driven->speed_through_water);
  }
}

TEST(GliderProfile, LeavesRoomForASawToothInTheShallowestWater) {
  GliderProfile profile;
  EXPECT_EQ(profile.least_water(), profile.minimum_working_depth);

  profile.altimeter_margin = {50.0};
  EXPECT_EQ(profile.least_water(), core::Metres{57.0});
}

TEST(GliderProfile, LeavesRoomForASawToothBelowAnUpperTurnToo) {
  GliderProfile profile;
  EXPECT_EQ(profile.least_water_below_turn(), profile.minimum_working_depth);

  profile.altimeter_margin = {30.0};
  EXPECT_EQ(profile.least_water_below_turn(), core::Metres{32.0});
  profile.minimum_working_depth = {0.0};
  profile.altimeter_margin = {0.0};
  EXPECT_EQ(profile.least_water_below_turn(), lowest_tooth);
}

TEST(GliderProfile, SinksAlongThePathOfItsPitch) {
  const GliderProfile profile;
  const auto glide = steady_glide(profile.hydrodynamics, profile.pitch, profile.buoyancy);

  EXPECT_NEAR(profile.vertical_speed(glide->horizontal).value, glide->vertical.value, 1e-12);
}

}  // namespace
}  // namespace floeplan::vehicle::glider_profile_test
