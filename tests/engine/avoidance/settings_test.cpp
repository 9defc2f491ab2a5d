#include "engine/avoidance/settings.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace floeplan::avoidance::settings_test {
namespace {

TEST(AvoidanceSettings, AreValidByDefault) { EXPECT_TRUE(AvoidanceSettings{}.violations().empty()); }

TEST(AvoidanceSettings, NameEveryFaultAtOnce) {
  AvoidanceSettings settings;
  settings.close = core::Metres{50.0};
  settings.deepest = core::Metres{1.0};
  settings.watch = core::Seconds{std::numeric_limits<double>::quiet_NaN()};

  const core::Violations found = settings.violations();

  std::vector<std::string> fields;
  for (const core::Violation& violation : found) fields.push_back(violation.field);
  EXPECT_EQ(fields, (std::vector<std::string>{"/watch", "/deepest", "/close", "/imminent"}));
}

}  // namespace
}  // namespace floeplan::avoidance::settings_test
