#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace floeplan::cli {

/// While it lives, SIGINT (Ctrl-C) and SIGTERM ask for a stop instead of ending the program; a second one ends it.
/// Threads  make it before any thread that shall not be interrupted: they take over which signals are held back
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }

 private:
  void wait(const std::stop_token& over);

  sigset_t signals_{};
  sigset_t before_{};
  std::stop_source stop_;
  std::jthread waiting_;
};

}  // namespace floeplan::cli
