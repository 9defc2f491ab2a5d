#include "api/codec/inputs/scenario_inputs.hpp"

#include <gtest/gtest.h>

namespace floeplan::codec::scenario_inputs_test {
namespace {

using nlohmann::json;

TEST(ScenarioInputs, HaveDefaultsAndComeBackAsTheyWent) {
  const auto inputs = parse_scenario_inputs({{"scenario", "random-icebergs"}, {"seed", 7}});
  ASSERT_TRUE(inputs);
  EXPECT_EQ(inputs->runs, 1);
  EXPECT_TRUE(inputs->avoidance);
  const json written = to_json(*inputs);
  EXPECT_EQ(to_json(parse_scenario_inputs(written).value()), written);
}

TEST(ScenarioInputs, NameEverythingThatIsWrongAtOnce) {
  const auto inputs = parse_scenario_inputs({{"scenario", "calm"}, {"runs", 0}, {"seed", -1}, {"speed", 1}});
  ASSERT_FALSE(inputs);
  EXPECT_EQ(inputs.error().size(), 4U);
  EXPECT_EQ(parse_scenario_inputs(json::object()).error().front().field, "/scenario");
}

}  // namespace
}  // namespace floeplan::codec::scenario_inputs_test
