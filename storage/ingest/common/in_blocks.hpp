#pragma once

#include <cstddef>
#include <type_traits>

namespace floeplan::ingest {

/// Calls `work(first, count)` for all indices below `size`: in blocks of 64, a count that the compiler knows,
/// then once with the rest. At the optimisation level of a release, GCC 12 vectorises only loops whose length
/// it knows.
template <class Work>
void in_blocks(std::size_t size, const Work& work) {
  constexpr std::integral_constant<std::size_t, 64> block{};
  std::size_t first = 0;
  for (; first + block <= size; first += block) work(first, block);
  work(first, size - first);
}

}  // namespace floeplan::ingest
