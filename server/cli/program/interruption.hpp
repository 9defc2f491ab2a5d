#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace floeplan::cli {

/// While an object of this class lives, SIGINT (Ctrl-C) and SIGTERM request a stop instead of ending the
/// program; a second signal ends it.
/// Threads  create it before threads that must not be interrupted, because they inherit the mask of blocked
///          signals
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
