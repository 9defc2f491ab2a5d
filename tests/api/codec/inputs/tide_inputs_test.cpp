#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/inputs/plan_inputs.hpp"

namespace floeplan::codec::tide_inputs_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json inputs_with(const json& members) {
  json inputs{{"from", {-53.2, 69.2}}, {"to", {-51.6, 69.2}}, {"depart", "2026-11-22T06:00:00Z"}};
  inputs.update(members);
  return inputs;
}

TEST(TideInputs, AreNoneUnlessAskedFor) {
  const auto inputs = parse_plan_inputs(inputs_with(json::object()));

  ASSERT_TRUE(inputs);
  EXPECT_FALSE(inputs->data.tides.wanted());
  const json written = to_json(*inputs);
  EXPECT_EQ(written.at("tides"), "none");
  EXPECT_TRUE(written.at("tides_mode").is_null());
  EXPECT_EQ(to_json(parse_plan_inputs(written).value()), written);
}

TEST(TideInputs, NameSeveralModelsAndWhatTheyAreFor) {
  const auto inputs =
      parse_plan_inputs(inputs_with({{"tides", {"tides-m2", "tides-k1"}}, {"tides_mode", "add"}}));

  ASSERT_TRUE(inputs);
  EXPECT_EQ(inputs->data.tides.choice.ids.size(), 2U);
  EXPECT_EQ(inputs->data.tides.mode, repository::TidesMode::add);
  EXPECT_EQ(to_json(parse_plan_inputs(to_json(*inputs)).value()), to_json(*inputs));
}

TEST(TideInputs, RefuseAnotherMode) {
  const auto inputs = parse_plan_inputs(inputs_with({{"tides", "newest"}, {"tides_mode", "both"}}));

  ASSERT_FALSE(inputs);
  EXPECT_EQ(inputs.error().front().field, "/tides_mode");
  EXPECT_THAT(inputs.error().front().rule, HasSubstr("add"));
}

}  // namespace
}  // namespace floeplan::codec::tide_inputs_test
