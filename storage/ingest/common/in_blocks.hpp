#pragma once

#include <cstddef>
#include <type_traits>

namespace floeplan::ingest {

/// Calls `work(first, count)` until all of `size` numbers are done: in blocks whose count is a constant, then once with
/// what is left. At the level of optimisation of a release GCC 12 makes vector instructions only of loops whose length
/// it knows.
template <class Work>
void in_blocks(std::size_t size, const Work& work) {
  constexpr std::integral_constant<std::size_t, 64> block{};
  std::size_t first = 0;
  for (; first + block <= size; first += block) work(first, block);
  work(first, size - first);
}

}  // namespace floeplan::ingest
