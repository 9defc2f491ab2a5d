#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/executor.hpp"
#include "engine/core/packed.hpp"

namespace floeplan::core {

/// Does parts with a result of type T each, see Executor::run_parts.
/// `work`  (index, is_caller) -> std::optional<T>; empty: it was stopped before its end
/// `take`  (index, T result, bool elsewhere); elsewhere: another process did the part, so that `work` did not run here
template <class T, class Work, class Take>
void run_packed_parts(const Executor& executor, std::size_t count, const Work& work, const Take& take) {
  std::vector<char> is_done_here(count, 0);  // no vector<bool>, because threads write to it at once
  const auto packed_work = [&](std::size_t index, bool is_caller) -> std::optional<std::string> {
    is_done_here[index] = 1;
    const std::optional<T> result = work(index, is_caller);
    return result ? std::optional{packed(*result)} : std::nullopt;
  };
  const auto take_packed = [&](std::size_t index, std::string_view result) {
    take(index, unpacked<T>(result), is_done_here[index] == 0);
  };
  executor.run_parts({.count = count, .work = packed_work, .take = take_packed});
}

}  // namespace floeplan::core
