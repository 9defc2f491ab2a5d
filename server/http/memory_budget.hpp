#pragma once

#include <cstdint>
#include <utility>

namespace floeplan::http {

/// Accounts for the use of a limited amount of memory.
/// Threads  the I/O thread alone
class MemoryBudget {
 public:
  explicit MemoryBudget(std::uint64_t most) : most_{most} {}

  [[nodiscard]] bool has(std::uint64_t bytes) const { return used_ + bytes <= most_; }

  /// Reserves bytes while it lives. May exceed the budget, because memory that is already used must be
  /// counted.
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
