#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace floeplan::core {

/// Runs independent pieces of work for the engine, which starts no threads itself: its caller decides how
/// many there are. Results do not depend on their number.
class Executor {
 public:
  /// `is_caller`  whether this thread is the one that called `run`; only it reports progress
  using Piece = std::function<void(std::size_t index, bool is_caller)>;

  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Calls `piece` once for every index below `count`, in any order and maybe on several threads at once.
  /// Each call must write only to data of its own. The calling thread may run pieces, too. Returns when all
  /// pieces have ended.
  /// Errors  rethrows the first exception of a piece; some pieces are then left out
  virtual void run(std::size_t count, const Piece& piece) const = 0;

  /// A job in parts whose results are bytes, so that another process may do some of the parts. That process
  /// does the same job with the same data and the same version, so it divides the job in the same way.
  struct Parts {
    std::size_t count{};
    /// Does a part, as a piece. Empty: it was stopped before its end.
    std::function<std::optional<std::string>(std::size_t index, bool is_caller)> work;
    /// Takes the result of a part, wherever it was done. Called on the thread that called `run_parts`, once for
    /// every part that came to its end.
    std::function<void(std::size_t index, std::string_view result)> take;
  };

  /// Does all parts. The results do not depend on where.
  /// Errors  as `run`
  virtual void run_parts(const Parts& parts) const;
};

/// An executor that runs one piece after another on the calling thread.
[[nodiscard]] const Executor& in_order();

/// Counts the pieces that have ended on any thread, and reports the count on the thread that called `run`.
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
