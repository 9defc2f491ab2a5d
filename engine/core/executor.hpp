#pragma once

#include <cstddef>
#include <functional>

namespace floeplan::core {

/// Does independent pieces of work for the engine, which starts no thread itself: the caller of the engine says how many
/// threads there are. Results do not depend on their number.
class Executor {
 public:
  using Piece = std::function<void(std::size_t index)>;
  using Count = std::function<void(std::size_t pieces)>;

  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Calls `piece` once for every index below `count`, in any order and maybe on several threads at once; each call writes
  /// to its own place only. Returns when all of them have ended.
  /// `ended`  is told now and then, on the calling thread, how many have ended
  /// Errors   rethrows the first exception of a piece; some pieces are then left out
  virtual void run(std::size_t count, const Piece& piece, const Count& ended) const = 0;
};

/// Does one piece after the other on the calling thread.
[[nodiscard]] const Executor& in_order();

}  // namespace floeplan::core
