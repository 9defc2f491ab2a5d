#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/inputs/ice_inputs.hpp"

namespace floeplan::codec::iceberg_inputs_test {
namespace {

using nlohmann::json;

struct Read {
  planning::IcebergRules rules;
  repository::EnvironmentQuery data;
  std::vector<std::string> faults;
};

Read read(const json& inputs) {
  InputReader reader{inputs};
  Read result;
  read_iceberg_rules(reader, result.rules, result.data);
  reader.refuse_unknown();
  for (const core::Violation& violation : reader.violations()) result.faults.push_back(violation.field);
  return result;
}

TEST(IcebergInputs, DriftByDefaultWithinBounds) {
  const Read defaults = read(json::object());

  EXPECT_TRUE(defaults.faults.empty());
  EXPECT_TRUE(defaults.rules.drift);
  EXPECT_TRUE(defaults.data.iceberg_drift);
  EXPECT_EQ(defaults.rules.margin.value, 500.0);
  EXPECT_EQ(defaults.rules.max_inflation.value, 5000.0);
  EXPECT_EQ(defaults.data.max_sighting_age.count(), 3.0 * 86'400.0);
}

TEST(IcebergInputs, AreWrittenAsTheyAreRead) {
  const json inputs{{"margin_m", 800.0},           {"icebergs_drift", false},  {"max_inflation_m", 0.0},
                    {"pass_under_icebergs", true}, {"keel_clearance_m", 30.0}, {"draft_uncertainty", 0.5},
                    {"max_sighting_age_days", 1.5}};

  const Read given = read(inputs);
  json written = json::object();
  write_iceberg_rules(given.rules, given.data, written);

  EXPECT_TRUE(given.faults.empty());
  EXPECT_FALSE(given.rules.drift);
  EXPECT_FALSE(given.data.iceberg_drift);
  EXPECT_EQ(written, inputs);
}

TEST(IcebergInputs, AreAllRefusedAtOnceWhenTheyAreWrong) {
  const Read given = read({{"margin_m", -1.0},
                           {"icebergs_drift", "yes"},
                           {"max_inflation_m", 1e6},
                           {"max_sighting_age_days", 31.0}});

  EXPECT_EQ(given.faults, (std::vector<std::string>{"/margin_m", "/icebergs_drift", "/max_inflation_m",
                                                    "/max_sighting_age_days"}));
}

}  // namespace
}  // namespace floeplan::codec::iceberg_inputs_test
