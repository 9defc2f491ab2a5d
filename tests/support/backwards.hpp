#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "engine/core/executor.hpp"

namespace floeplan::support {

/// Runs the pieces of work in reverse order, on three threads.
class Backwards final : public core::Executor {
 public:
  void run(std::size_t count, const Piece& piece) const override {
    std::atomic<std::size_t> left{count};
    const auto work = [&] {
      for (std::size_t next = left.load(); next > 0;) {
        if (!left.compare_exchange_weak(next, next - 1)) continue;
        piece(next - 1, false);
        next = left.load();
      }
    };
    std::vector<std::jthread> threads;
    for (int i = 0; i < 3; ++i) threads.emplace_back(work);
  }
};

}  // namespace floeplan::support
