#pragma once

#include <poll.h>

#include <chrono>

namespace floeplan::support {

/// True as soon as `condition` holds; false when it does not within a minute.
template <class Condition>
bool wait_until(const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes{1};
  while (std::chrono::steady_clock::now() < deadline) {
    if (condition()) return true;
    constexpr int look_again_ms = 10;  // another process or thread makes the condition true
    poll(nullptr, 0, look_again_ms);
  }
  return false;
}

}  // namespace floeplan::support
