#include "api/codec/inputs/vehicle_inputs.hpp"

#include <gmock/gmock.h>

namespace floeplan::codec::vehicle_inputs_test {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

struct Read {
  vehicle::GliderProfile profile;
  core::Violations violations;
};

Read read(const json& inputs) {
  InputReader reader{inputs};
  Read result;
  read_vehicle(reader, result.profile);
  reader.refuse_unknown();
  result.violations = reader.violations();
  return result;
}

TEST(VehicleInputs, AreTheFirstProfileWhenNothingIsSaid) {
  const Read result = read(json::object());

  EXPECT_THAT(result.violations, IsEmpty());
  EXPECT_EQ(result.profile, vehicle::known_profiles().front());
}

TEST(VehicleInputs, OverrideMembersOfAProfile) {
  const Read result =
      read({{"vehicle",
             {{"profile", "slocum-g2-1000"}, {"name", "nunatak"}, {"hotel_w", 3.5}, {"battery_j", 9e6}}},
            {"dive_depth_m", 800.0}});

  EXPECT_THAT(result.violations, IsEmpty());
  auto expected = vehicle::find_profile("slocum-g2-1000").value();
  expected.name = "nunatak";
  expected.energy.hotel = {3.5};
  expected.energy.battery = {9e6};
  expected.dive_depth = {800.0};
  EXPECT_EQ(result.profile, expected);
}

TEST(VehicleInputs, TakeTheSpeedOfTheGlideFromPitchAndBuoyancy) {
  const Read result = read({{"vehicle", {{"buoyancy_cm3", 230.0}}}, {"pitch_deg", 26.0}});

  EXPECT_THAT(result.violations, IsEmpty());
  EXPECT_NEAR(result.profile.speed_through_water.value, 0.3144, 1e-4);
}

TEST(VehicleInputs, KeepASpeedThatIsGivenBesideThePitch) {
  EXPECT_EQ(read({{"pitch_deg", 30.0}, {"speed_m_s", 0.3}}).profile.speed_through_water.value, 0.3);
  EXPECT_EQ(read({{"pitch_deg", 30.0}, {"vehicle", {{"speed_m_s", 0.3}}}}).profile.speed_through_water.value,
            0.3);
}

TEST(VehicleInputs, GiveAThrusterThePowerThatItsSpeedNeeds) {
  const Read fitted = read({{"vehicle", {{"thruster", {{"speed_m_s", 0.7}}}}}});
  const Read measured = read({{"vehicle", {{"thruster", {{"speed_m_s", 0.7}, {"power_w", 12.0}}}}}});
  const Read removed = read({{"vehicle", {{"profile", "slocum-g3-200-thruster"}, {"thruster", false}}}});

  EXPECT_EQ(fitted.profile.thruster->power, vehicle::thruster_power({0.7}));
  EXPECT_EQ(measured.profile.thruster->power.value, 12.0);
  EXPECT_FALSE(removed.profile.thruster.has_value());
}

TEST(VehicleInputs, NameEveryFaultAtOnce) {
  const Read result = read({{"vehicle",
                             {{"profile", "submarine"},
                              {"speed_m_s", 0.0},
                              {"battery_j", -1.0},
                              {"pump", "strong"},
                              {"thruster", {{"speed_m_s", 0.0}, {"blades", 3}}}}},
                            {"battery_start_share", 2.0},
                            {"climb_to_m", 300.0}});

  for (const char* field :
       {"/vehicle/profile", "/vehicle/speed_m_s", "/vehicle/battery_j", "/vehicle/pump",
        "/vehicle/thruster/speed_m_s", "/vehicle/thruster/blades", "/battery_start_share", "/climb_to_m"}) {
    EXPECT_THAT(result.violations, Contains(Field(&core::Violation::field, field))) << field;
  }
}

/// With another vehicle these inputs stay, and the members of "vehicle" are dropped.
TEST(VehicleInputs, TellWhatIsSaidBesideTheVehicle) {
  const json inputs{{"vehicle", {{"profile", "slocum-g3-200"}, {"climb_to_m", 8.0}}},
                    {"speed_m_s", 0.4},
                    {"pitch_deg", 24.0},
                    {"dive_depth_m", 200.0},
                    {"battery_j", 5e6}};
  InputReader reader{inputs};
  vehicle::GliderProfile profile;

  const vehicle::FlightChoices choices = read_vehicle(reader, profile);

  EXPECT_THAT(reader.violations(), IsEmpty());
  EXPECT_EQ(choices.speed_through_water, core::MetresPerSecond{0.4});
  EXPECT_EQ(choices.pitch, profile.pitch);
  EXPECT_EQ(choices.dive_depth, core::Metres{200.0}) << "though the profile has it already";
  EXPECT_EQ(choices.battery, core::Joules{5e6});
  EXPECT_FALSE(choices.climb_to || choices.altimeter_margin || choices.battery_start_share);
}

TEST(VehicleInputs, ListTheKnownProfiles) {
  const Read result = read({{"vehicle", "submarine"}});

  EXPECT_THAT(result.violations, Contains(Field(&core::Violation::rule, HasSubstr("slocum-g2-30-thruster"))));
}

TEST(VehicleInputs, AreReadBackAsTheyWereWritten) {
  const json free{
      {"profile", "slocum-g3-30-thruster"}, {"name", "nunatak"}, {"surfacing_interval_s", 10800.0}};
  for (const json& inputs : {json::object(), json{{"vehicle", "slocum-g2-30-thruster"}, {"pitch_deg", 22.0}},
                             json{{"vehicle", free}, {"dive_depth_m", 25.0}}}) {
    const Read first = read(inputs);
    ASSERT_THAT(first.violations, IsEmpty());
    json written;
    write_vehicle(first.profile, written);

    const Read second = read(written);

    EXPECT_THAT(second.violations, IsEmpty());
    json again;
    write_vehicle(second.profile, again);
    EXPECT_EQ(again, written);
    EXPECT_EQ(second.profile.name, first.profile.name);
  }
}

TEST(VehicleInputs, WriteAKnownVehicleByItsName) {
  json written;
  write_vehicle(read({{"vehicle", "slocum-g2-200"}, {"battery_start_share", 0.5}}).profile, written);

  EXPECT_EQ(written["vehicle"], "slocum-g2-200");
  EXPECT_EQ(written["battery_start_share"], 0.5);
}

}  // namespace
}  // namespace floeplan::codec::vehicle_inputs_test
