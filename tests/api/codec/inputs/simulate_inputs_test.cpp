#include "api/codec/inputs/simulate_inputs.hpp"

#include <gmock/gmock.h>

namespace floeplan::codec::simulate_inputs_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

std::vector<std::string> faults_of(const json& inputs) {
  const auto parsed = parse_simulate_inputs(inputs);
  std::vector<std::string> fields;
  if (!parsed) {
    for (const core::Violation& violation : parsed.error()) fields.push_back(violation.field);
  }
  return fields;
}

TEST(SimulateInputs, AreOneFlightWithTheSystemOnBoardWhenOnlyThePlanIsNamed) {
  const auto parsed = parse_simulate_inputs({{"plan_id", "p1"}});

  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->runs, 1);
  EXPECT_EQ(parsed->tracks, 1);
  EXPECT_EQ(parsed->seed, 1U);
  EXPECT_TRUE(parsed->avoidance);
  EXPECT_EQ(parsed->sonar, simulation::SonarSettings{});
  EXPECT_FALSE(parsed->longest);
}

TEST(SimulateInputs, WrittenOutReadBackToTheSame) {
  const json given{{"plan_id", "p1"},
                   {"runs", 50},
                   {"seed", 7},
                   {"tracks", 3},
                   {"avoidance", false},
                   {"current_error", {{"rms_m_s", 0.1}, {"length_scale_m", 5000.0}}},
                   {"sonar", {{"range_m", 150.0}, {"beam_step_deg", 2.0}, {"water", {{"wind_m_s", 0.0}}}}},
                   {"adcp", {{"cells", 10}, {"attitude_sigma_deg", 0.4}}},
                   {"altimeter", {{"false_echo_share", 0.01}}},
                   {"navigation", {{"compass_sigma_deg", 3.0}}},
                   {"currents", json::array({"a", "b"})},
                   {"longest_s", 7200.0},
                   {"mission_files", json::array({{{"name", "goto_l10.ma"}, {"text", "x"}}})},
                   {"name", "with errors"}};
  const auto first = parse_simulate_inputs(given);
  ASSERT_TRUE(first);
  const json written = to_json(*first);
  const auto second = parse_simulate_inputs(written);
  ASSERT_TRUE(second);

  EXPECT_EQ(to_json(*second), written);
  EXPECT_EQ(written.at("sonar").at("beam_step_deg"), 2.0);
  EXPECT_EQ(written.at("adcp").at("attitude_sigma_deg"), 0.4);
  EXPECT_EQ(written.at("currents"), given.at("currents"));
  EXPECT_EQ(second->sonar.water.wind_m_s, 0.0);
  EXPECT_EQ(second->mission_files.front().name, "goto_l10.ma");
}

TEST(SimulateInputs, AreRefusedWithEveryFault) {
  EXPECT_THAT(faults_of({{"runs", 0},
                         {"seed", -1},
                         {"sonar", {{"range_m", -5.0}, {"rows", 0}}},
                         {"adcp", {{"cells", 1}}},
                         {"altimeter", {{"colour", "red"}}},
                         {"current_error", {{"rms_m_s", -0.1}}},
                         {"longest_s", 1e12},
                         {"unknown", 1}}),
              ElementsAre("/plan_id", "/runs", "/seed", "/current_error/rms_m_s", "/sonar/range_m",
                          "/sonar/rows", "/altimeter/colour", "/adcp/cells", "/longest_s", "/unknown"));
}

TEST(SimulateInputs, ThatAreNoObjectsAreRefused) {
  EXPECT_FALSE(faults_of(json::array()).empty());
  EXPECT_FALSE(faults_of({{"plan_id", "p1"}, {"sonar", 5}}).empty());
  EXPECT_FALSE(faults_of({{"plan_id", "p1"}, {"mission_files", "goto_l10.ma"}}).empty());
  EXPECT_FALSE(faults_of({{"plan_id", "p1"}, {"mission_files", json::array({5})}}).empty());
}

TEST(SimulateInputs, SayWhatASettingMayBe) {
  const auto parsed = parse_simulate_inputs({{"plan_id", "p1"}, {"sonar", {{"beam_width_deg", 90.0}}}});

  ASSERT_FALSE(parsed);
  EXPECT_THAT(parsed.error(),
              ElementsAre(Field(&core::Violation::rule, HasSubstr("must be from 0.5 to 40, not 90"))));
}

}  // namespace
}  // namespace floeplan::codec::simulate_inputs_test
