#include "api/codec/inputs/uncertainty_inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floeplan::codec::uncertainty_inputs_test {
namespace {

using nlohmann::json;
using planning::RobustObjective;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Read {
  planning::UncertaintyRules rules;
  core::Violations violations;
};

Read read(const json& uncertainty) {
  const json document{{"uncertainty", uncertainty}};
  InputReader reader{document};
  Read result{.rules = read_uncertainty(reader), .violations = {}};
  result.violations = reader.violations();
  return result;
}

std::vector<std::string> faults(const json& uncertainty) {
  std::vector<std::string> fields;
  for (const core::Violation& violation : read(uncertainty).violations) fields.push_back(violation.field);
  return fields;
}

TEST(UncertaintyInputs, TellWhatIsToBeLeast) {
  const Read mean = read({{"objective", "mean"}});
  const Read early = read({{"objective", "quantile"}, {"quantile", 0.75}});

  EXPECT_THAT(mean.violations, IsEmpty());
  EXPECT_EQ(mean.rules.objective, RobustObjective::mean);
  EXPECT_THAT(early.violations, IsEmpty());
  EXPECT_EQ(early.rules.objective, RobustObjective::quantile);
  EXPECT_EQ(early.rules.quantile, 0.75);
}

/// Without this refusal the quantile would be ignored, and the route would be that of the first member.
TEST(UncertaintyInputs, RefuseAQuantileThatNothingIsMadeTheBestOf) {
  const Read alone = read({{"quantile", 0.75}});

  ASSERT_EQ(alone.violations.size(), 1U);
  EXPECT_EQ(alone.violations.front().field, "/uncertainty/quantile");
  EXPECT_THAT(alone.violations.front().rule, HasSubstr("objective"));
}

TEST(UncertaintyInputs, NameEveryFault) {
  EXPECT_THAT(faults({{"objective", "best"}, {"quantile", 1.5}, {"arrive_before", "soon"}, {"menbers", 3}}),
              ElementsAre("/uncertainty/objective", "/uncertainty/quantile", "/uncertainty/arrive_before",
                          "/uncertainty/menbers"));
  EXPECT_THAT(faults({{"members", 8}}),
              ElementsAre("/uncertainty/current_error_m_s", "/uncertainty/length_scale_m",
                          "/uncertainty/time_scale_s"));
  EXPECT_THAT(faults({{"current_error_m_s", 0.05}, {"length_scale_m", 2e4}, {"time_scale_s", 7200}}),
              ElementsAre("/uncertainty/members"));
}

TEST(UncertaintyInputs, ComeBackTheSameFromTheirOwnText) {
  const json drawn{{"objective", nullptr},
                   {"quantile", nullptr},
                   {"arrive_before", "2026-11-25T06:00:00Z"},
                   {"members", 8},
                   {"current_error_m_s", 0.05},
                   {"length_scale_m", 20000.0},
                   {"time_scale_s", 7200.0},
                   {"seed", 7}};
  const json early{{"objective", "quantile"}, {"quantile", 0.75}, {"arrive_before", nullptr}};
  const json mean{{"objective", "mean"}, {"quantile", nullptr}, {"arrive_before", nullptr}};

  for (const json& inputs : {drawn, early, mean}) {
    const Read first = read(inputs);
    EXPECT_THAT(first.violations, IsEmpty());
    EXPECT_EQ(uncertainty_json(first.rules), inputs);
  }
  EXPECT_EQ(uncertainty_json(planning::UncertaintyRules{}), json());
}

}  // namespace
}  // namespace floeplan::codec::uncertainty_inputs_test
