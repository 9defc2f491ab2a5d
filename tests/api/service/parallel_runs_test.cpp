#include "api/service/parallel_runs.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace floeplan::service::parallel_runs_test {
namespace {

constexpr auto no_report = [](std::size_t) {};

TEST(ParallelRuns, DoEveryRunOnceWithAnyNumberOfWorkers) {
  for (const std::size_t workers : {1U, 2U, 7U, 100U}) {
    std::vector<int> done(53);
    run_in_parallel(
        done.size(), workers, {}, [&](std::size_t i, const std::stop_token&) { ++done[i]; }, no_report);

    EXPECT_EQ(done, std::vector<int>(53, 1)) << workers;
  }
}

TEST(ParallelRuns, BeginNoMoreOnceTheyAreToldToStop) {
  std::stop_source stop;
  std::atomic<int> begun{0};

  run_in_parallel(
      1000, 3, stop.get_token(),
      [&](std::size_t, const std::stop_token& run_stop) {
        if (++begun == 5) stop.request_stop();
        while (begun >= 5 && !run_stop.stop_requested()) {
        }
      },
      no_report);

  EXPECT_LE(begun, 5 + 3);
}

TEST(ParallelRuns, PassOnWhatARunThrows) {
  const auto fails = [](std::size_t i, const std::stop_token&) {
    if (i == 4) throw std::runtime_error{"no memory"};
  };

  EXPECT_THROW(run_in_parallel(10, 2, {}, fails, no_report), std::runtime_error);
}

TEST(ParallelRuns, OfNoRunsAreDoneAtOnce) {
  run_in_parallel(0, 4, {}, [](std::size_t, const std::stop_token&) { FAIL(); }, no_report);
}

}  // namespace
}  // namespace floeplan::service::parallel_runs_test
