#include "storage/repository/fields/forecast_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/property.hpp"

namespace floeplan::repository::forecast_runs_test {
namespace {

using Runs = std::vector<std::vector<double>>;

TEST(NewestSteps, ReplaceTheForecastAndKeepThePast) {
  const Runs runs{{6.0, 9.0, 12.0}, {0.0, 3.0, 6.0, 9.0}};

  EXPECT_EQ(newest_steps(runs, 7.0, false), (std::vector<RunSteps>{{1, 0.0, 3.0}, {0, 6.0, 12.0}}));
}

TEST(NewestSteps, FollowAnOlderRunThatLooksFurther) {
  const Runs runs{{6.0, 9.0}, {0.0, 6.0, 12.0, 18.0}};

  EXPECT_EQ(newest_steps(runs, 6.0, false),
            (std::vector<RunSteps>{{1, 0.0, 0.0}, {0, 6.0, 9.0}, {1, 12.0, 18.0}}));
}

TEST(NewestSteps, EndWhereTheNextRunIsFurtherAwayThanTheLongestStepOfBoth) {
  const Runs runs{{100.0, 110.0}, {0.0, 10.0, 20.0}};

  EXPECT_EQ(newest_steps(runs, 5.0, false), (std::vector<RunSteps>{{1, 0.0, 20.0}}));
  EXPECT_TRUE(newest_steps(runs, 50.0, false).empty());
  EXPECT_EQ(newest_steps(runs, 50.0, true), (std::vector<RunSteps>{{0, 100.0, 110.0}}));
}

TEST(NewestSteps, NeverJoinTwoSnapshots) {
  const Runs runs{{86400.0}, {0.0}};

  EXPECT_EQ(newest_steps(runs, 0.0, false), (std::vector<RunSteps>{{1, 0.0, 0.0}}));
}

TEST(NewestSteps, NeverTakeAStepThatANewerRunCovers) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    std::uniform_int_distribution<int> count{1, 6};
    std::uniform_int_distribution<int> start{0, 40};
    Runs runs(static_cast<std::size_t>(count(rng)));
    for (auto& run : runs) {
      double time_s = 100.0 * start(rng);
      for (int step = count(rng); step > 0; --step) {
        run.push_back(time_s);
        time_s += 100.0 * count(rng);
      }
    }
    const double wanted_s = 100.0 * start(rng);
    const auto steps = newest_steps(runs, wanted_s, false);
    const bool covered = std::ranges::any_of(
        runs, [&](const auto& run) { return run.front() <= wanted_s && wanted_s <= run.back(); });
    ASSERT_TRUE(!covered || !steps.empty());
    if (steps.empty()) return;
    ASSERT_LE(steps.front().first_s, wanted_s);
    ASSERT_GE(steps.back().last_s, wanted_s);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      ASSERT_TRUE(i == 0 || steps[i - 1].last_s < steps[i].first_s);
      for (const double end_s : {steps[i].first_s, steps[i].last_s})
        for (std::size_t newer = 0; newer < steps[i].run; ++newer)
          ASSERT_FALSE(runs[newer].front() <= end_s && end_s <= runs[newer].back());
    }
  });
}

}  // namespace
}  // namespace floeplan::repository::forecast_runs_test
