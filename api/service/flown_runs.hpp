#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <utility>

#include "engine/core/executor.hpp"
#include "engine/core/packed_parts.hpp"
#include "engine/core/progress.hpp"

namespace floeplan::service {

/// Flies each run below `count` by `fly(run)`, which returns a Run, and passes it to `take(run, Run)`. Maybe in other
/// processes, too. Once `stop` is requested, runs are left out.
/// Errors  rethrows the first exception of a run
template <class Run, class Fly, class Take>
void fly_runs(std::size_t count, const core::Executor& executor, const std::stop_token& stop,
              const core::ProgressCallback& progress, const Fly& fly, const Take& take) {
  const auto tell = [&](std::size_t ended) {
    if (progress) progress("flying", static_cast<double>(ended) / static_cast<double>(count));
  };
  tell(0);
  core::CountOfEnded flown{tell};
  core::run_packed_parts<Run>(
      executor, count,
      [&](std::size_t run, bool is_caller) -> std::optional<Run> {
        if (stop.stop_requested()) return std::nullopt;
        Run done = fly(run);
        if (stop.stop_requested()) return std::nullopt;
        flown.add(is_caller);
        return done;
      },
      [&](std::size_t run, Run done, bool elsewhere) {
        take(run, std::move(done));
        if (elsewhere) flown.add(true);
      });
}

}  // namespace floeplan::service
