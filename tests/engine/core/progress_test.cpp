#include "engine/core/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/property.hpp"

namespace floeplan::core {
namespace {

using Reports = std::vector<std::pair<std::string, double>>;

ProgressCallback into(Reports& reports) {
  return [&reports](std::string_view stage, double share) { reports.emplace_back(stage, share); };
}

TEST(NeverFalling, ReportsTheLargestShareSoFar) {
  Reports reports;
  const ProgressCallback listener = into(reports);
  const ProgressCallback progress = never_falling(listener);

  progress("search", 0.4);
  progress("wider area", 0.0);
  progress("wider area", 0.7);

  EXPECT_EQ(reports, (Reports{{"search", 0.4}, {"wider area", 0.4}, {"wider area", 0.7}}));
}

TEST(NeverFalling, StaysBetweenZeroAndOneWhateverIsReported) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    Reports reports;
    const ProgressCallback listener = into(reports);
    const ProgressCallback progress = never_falling(listener);

    for (int i = 0; i < 20; ++i) progress("search", support::uniform(rng, -0.5, 1.5));

    EXPECT_TRUE(std::ranges::is_sorted(reports, {}, &Reports::value_type::second));
    EXPECT_GE(reports.front().second, 0.0);
    EXPECT_LE(reports.back().second, 1.0);
  });
}

TEST(NeverFalling, DoesNothingWithoutAListener) {
  const ProgressCallback nobody;
  EXPECT_NO_THROW(never_falling(nobody)("search", 0.5));
}

TEST(PartsOfProgress, GiveEachPartHalfOfTheRestUnlessToldOtherwise) {
  Reports reports;
  const ProgressCallback listener = into(reports);
  PartsOfProgress parts{listener, ""};

  for (int i = 0; i < 3; ++i) {
    const ProgressCallback part = parts.next();
    part("begins", 0.0);
    part("ends", 1.0);
  }

  EXPECT_EQ(reports, (Reports{{"begins", 0.0},
                              {"ends", 0.5},
                              {"begins", 0.5},
                              {"ends", 0.75},
                              {"begins", 0.75},
                              {"ends", 0.875}}));
  reports.clear();
  PartsOfProgress others{listener, "", PartsOfProgress::mostly_one};
  others.next()("ends", 1.0);
  others.next()("ends", 1.0);
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_DOUBLE_EQ(reports[0].second, 0.8);
  EXPECT_DOUBLE_EQ(reports[1].second, 0.96);
}

}  // namespace
}  // namespace floeplan::core
