#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <utility>

namespace floeplan::core {

/// Does independent pieces of work for the engine, which starts no thread itself: the caller of the engine says how many
/// threads there are. Results do not depend on their number.
class Executor {
 public:
  /// `is_caller`  whether this is the thread that called `run`, where progress is listened to
  using Piece = std::function<void(std::size_t index, bool is_caller)>;

  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Calls `piece` once for every index below `count`, in any order and maybe on several threads at once; each call writes
  /// to its own place only. The calling thread may do pieces, too. Returns when all of them have ended.
  /// Errors  rethrows the first exception of a piece; some pieces are then left out
  virtual void run(std::size_t count, const Piece& piece) const = 0;
};

/// Does one piece after the other on the calling thread.
[[nodiscard]] const Executor& in_order();

/// Counts what has ended on several threads, and tells of it on the one that called `run`.
class CountOfEnded {
 public:
  explicit CountOfEnded(std::function<void(std::size_t)> listener) : listener_{std::move(listener)} {}

  void add(bool is_caller) {
    const std::size_t ended = ++ended_;
    if (is_caller) listener_(ended);
  }

 private:
  std::function<void(std::size_t)> listener_;
  std::atomic<std::size_t> ended_{0};
};

}  // namespace floeplan::core
