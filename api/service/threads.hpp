#pragma once

#include <cstddef>

#include "engine/core/executor.hpp"

namespace floeplan::service {

/// Does the work of the engine on a number of threads, the calling one among them.
class Threads final : public core::Executor {
 public:
  /// `workers`  at least 1
  explicit Threads(std::size_t workers) : workers_{workers} {}

  /// Begins no further piece once one has thrown.
  void run(std::size_t count, const Piece& piece) const override;

 private:
  std::size_t workers_;
};

}  // namespace floeplan::service
