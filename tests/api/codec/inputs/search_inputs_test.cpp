#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/inputs/plan_input_parts.hpp"

namespace floeplan::codec::search_inputs_test {
namespace {

using nlohmann::json;

planning::PlanRequest read(const json& document) {
  InputReader reader{document};
  planning::PlanRequest request;
  read_search(reader, request);
  EXPECT_TRUE(reader.violations().empty());
  return request;
}

TEST(SearchInputs, AskForTheOptimalityGapUnlessToldOtherwise) {
  EXPECT_TRUE(read(json::object()).optimality_gap);
  EXPECT_FALSE(read({{"optimality_gap", false}}).optimality_gap);
}

TEST(SearchInputs, AreWrittenOutAsTheyAreRead) {
  planning::PlanRequest request;
  request.optimality_gap = false;
  request.sectors = 2;
  json inputs = json::object();

  write_search(request, inputs);

  EXPECT_EQ(inputs["optimality_gap"], false);
  EXPECT_EQ(inputs["sectors"], 2);
}

TEST(SearchInputs, RefuseAnOptimalityGapThatIsNoSwitch) {
  const json document{{"optimality_gap", "yes"}};
  InputReader reader{document};
  planning::PlanRequest request;

  read_search(reader, request);

  ASSERT_EQ(reader.violations().size(), 1U);
  EXPECT_EQ(reader.violations().front().field, "/optimality_gap");
}

}  // namespace
}  // namespace floeplan::codec::search_inputs_test
