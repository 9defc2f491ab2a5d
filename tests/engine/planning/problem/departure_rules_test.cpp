#include "engine/planning/problem/departure_rules.hpp"

#include <gmock/gmock.h>

namespace floeplan::planning::departure_rules_test {
namespace {

const core::UtcTime depart = core::from_unix_seconds(1.8e9);

std::vector<std::string> fields(const DepartureRules& rules) {
  std::vector<std::string> result;
  for (const auto& violation : rules.violations(depart)) result.push_back(violation.field);
  return result;
}

TEST(DepartureRules, HoldWithoutAWindow) {
  EXPECT_TRUE(fields({}).empty());
  EXPECT_EQ(DepartureRules{}.departures(depart), std::vector{depart});
}

TEST(DepartureRules, HoldTheLastDepartureThatAStepMeetsInspiteOfRounding) {
  const DepartureRules tenths{
      .until = depart + core::Seconds{1.2}, .step = core::Seconds{0.4}, .arrive_by = {}};
  EXPECT_EQ(tenths.departures(depart).size(), 4U);

  const DepartureRules uneven{
      .until = depart + core::Seconds{5000.0}, .step = core::Seconds{3600.0}, .arrive_by = {}};
  EXPECT_EQ(uneven.departures(depart).size(), 2U);
}

TEST(DepartureRules, RefuseAWindowThatEndsBeforeItBegins) {
  EXPECT_THAT(fields({.until = depart - core::Seconds{1.0}}), testing::ElementsAre("/depart_until"));
}

TEST(DepartureRules, RefuseAStepThatLeadsNowhere) {
  for (const double step_s : {0.0, -3600.0}) {
    EXPECT_THAT(fields({.until = depart + core::Seconds{3600.0}, .step = core::Seconds{step_s}}),
                testing::ElementsAre("/depart_step"));
  }
}

TEST(DepartureRules, RefuseMoreDeparturesThanTheLimitAndSayIt) {
  DepartureRules rules{.until = depart + core::Seconds{999.0 * 60.0}, .step = core::Seconds{60.0}};
  EXPECT_TRUE(fields(rules).empty());
  EXPECT_EQ(rules.departures(depart).size(), 1000U);

  rules.until = depart + core::Seconds{1000.0 * 60.0};
  ASSERT_THAT(fields(rules), testing::ElementsAre("/depart_step"));
  EXPECT_THAT(rules.violations(depart).front().rule, testing::HasSubstr("1000"));
}

TEST(DepartureRules, RefuseAnArrivalBeforeTheDepartureAndOneBesideAWindow) {
  EXPECT_THAT(fields({.arrive_by = depart}), testing::ElementsAre("/arrive_by"));
  EXPECT_THAT(fields({.until = depart + core::Seconds{7200.0}, .arrive_by = depart + core::Seconds{9e4}}),
              testing::ElementsAre("/arrive_by"));
}

}  // namespace
}  // namespace floeplan::planning::departure_rules_test
