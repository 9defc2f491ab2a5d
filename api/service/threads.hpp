#pragma once

#include <cstddef>
#include <thread>

#include "api/service/parallel_runs.hpp"
#include "engine/core/executor.hpp"

namespace floeplan::service {

/// Executes the engine's tasks on `workers` threads, including the calling thread.
class Threads final : public core::Executor {
 public:
  explicit Threads(std::size_t workers) : workers_{workers} {}

  void run(std::size_t count, const Piece& piece) const override {
    const auto caller = std::this_thread::get_id();
    const auto run = [&](std::size_t i, const std::stop_token&) {
      piece(i, std::this_thread::get_id() == caller);
    };
    run_in_parallel(count, workers_, {}, run, [](std::size_t) {});
  }

 private:
  std::size_t workers_;
};

}  // namespace floeplan::service
