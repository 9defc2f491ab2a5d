#include "api/service/threads.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace floeplan::service {

void Threads::run(std::size_t count, const Piece& piece) const {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> has_failed{false};
  std::mutex mutex;
  std::exception_ptr first_failure;

  const auto work = [&](bool is_caller) {
    for (std::size_t i = next++; i < count && !has_failed; i = next++) {
      try {
        piece(i, is_caller);
      } catch (...) {
        const std::lock_guard lock{mutex};
        if (!first_failure) first_failure = std::current_exception();
        has_failed = true;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(workers_, count); ++i) others.emplace_back([&] { work(false); });
    work(true);
  }
  if (first_failure) std::rethrow_exception(first_failure);
}

}  // namespace floeplan::service
