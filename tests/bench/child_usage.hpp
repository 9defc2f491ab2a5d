#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace floeplan::bench {

/// Time and memory of work in a separate process, including the processes that it started.
struct ChildUsage {
  double cpu_s{};
  double largest_mb{};  // resident memory of the largest of the processes
};

/// Runs `work` in a separate process; `work` may execute another program.
/// Errors   std::runtime_error when it throws or ends with another code than the expected one
template <class Work>
ChildUsage usage_of(const Work& work, int expected_code = 0) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error{"cannot start a process"};
  if (child == 0) {
    try {
      work();
      _exit(0);
    } catch (...) {
      _exit(127);
    }
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != expected_code)
    throw std::runtime_error{"work in a process of its own failed"};
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1000.0};
}

}  // namespace floeplan::bench
