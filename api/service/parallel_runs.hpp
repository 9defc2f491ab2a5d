#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace floeplan::service {

/// Calls `run(i, stop)` for every i below `count`, on `workers` threads; each call must write only to its own
/// data. `report` is called on the calling thread with the number of finished runs.
/// Stops    starts no further run once `stop` is requested, and returns when the running ones have ended
/// Errors   rethrows the first exception of a run, after the other runs have ended
template <class Run, class Report>
void run_in_parallel(std::size_t count, std::size_t workers, const std::stop_token& stop, const Run& run,
                     const Report& report) {
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> ended{0};
  std::stop_source fault;
  std::mutex mutex;
  std::exception_ptr first_fault;
  const std::stop_callback pass_on{stop, [&] { fault.request_stop(); }};

  const auto work = [&](bool reports) {
    for (std::size_t i = next++; i < count && !fault.stop_requested(); i = next++) {
      try {
        run(i, fault.get_token());
      } catch (...) {
        const std::lock_guard lock{mutex};
        if (!first_fault) first_fault = std::current_exception();
        fault.request_stop();
      }
      const std::size_t done = ++ended;
      if (reports) report(done);
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(workers, count); ++i) others.emplace_back([&] { work(false); });
    work(true);
  }
  if (first_fault) std::rethrow_exception(first_fault);
}

}  // namespace floeplan::service
