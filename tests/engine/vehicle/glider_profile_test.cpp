#include "engine/vehicle/glider_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

namespace floeplan::vehicle {
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

TEST(GliderProfile, TakesTheLimitsThemselves) {
  GliderProfile profile;
  profile.speed_through_water = {0.05};
  profile.dive_depth = {1.0};
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
        Fault{"DivesTooShallow", [](GliderProfile& p) { p.dive_depth = {0.9}; }, "/dive_depth_m"},
        Fault{"DivesBelowItsRating", [](GliderProfile& p) { p.dive_depth = {200.1}; }, "/dive_depth_m"},
        Fault{"RatedBeyondTheDeepestSea", [](GliderProfile& p) { p.depth_rating = {12'000.0}; }, "/vehicle"},
        Fault{"NegativeWorkingDepth", [](GliderProfile& p) { p.minimum_working_depth = {-1.0}; }, "/vehicle"},
        Fault{"NegativeAltimeterMargin", [](GliderProfile& p) { p.altimeter_margin = {-1.0}; }, "/vehicle"},
        Fault{"TakesNoWaypoint", [](GliderProfile& p) { p.max_waypoints_per_list = 0; }, "/vehicle"}),
    [](const auto& fault) { return fault.param.title; });

TEST(GliderProfile, TellsAllFaultsAtOnce) {
  GliderProfile profile;
  profile.speed_through_water = {0.0};
  profile.dive_depth = {0.0};
  profile.depth_rating = {0.0};

  const core::Violations found = profile.violations();

  EXPECT_EQ(found.size(), 3U);
  EXPECT_THAT(found, Contains(Field(&core::Violation::field, "/speed_m_s")));
  EXPECT_THAT(found, Contains(Field(&core::Violation::field, "/dive_depth_m")));
  EXPECT_THAT(found, Contains(Field(&core::Violation::field, "/vehicle")));
}

}  // namespace
}  // namespace floeplan::vehicle
