#pragma once

#include <cstdint>
#include <utility>

namespace floeplan::http {

/// How much of a bounded amount of memory is spoken for.
/// Threads  the I/O thread alone
class MemoryBudget {
 public:
  explicit MemoryBudget(std::uint64_t most) : most_{most} {}

  [[nodiscard]] bool has(std::uint64_t bytes) const { return used_ + bytes <= most_; }

  /// Bytes that are spoken for while it lives. More than there are can be taken: what is there already must be counted.
  class Part {
   public:
    Part(MemoryBudget& budget, std::uint64_t bytes) : budget_{budget}, bytes_{bytes} {
      budget_.used_ += bytes_;
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    ~Part() { budget_.used_ -= bytes_; }

   private:
    MemoryBudget& budget_;  // borrowed
    std::uint64_t bytes_;
  };

 private:
  std::uint64_t most_;
  std::uint64_t used_{0};
};

}  // namespace floeplan::http
