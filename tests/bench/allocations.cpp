#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/bench/report.hpp"

/// Counts the heap memory that the program uses. These operators replace those of the whole program, so they
/// are in their own file.
namespace {

std::atomic<std::size_t> in_use{0};
std::atomic<std::size_t> peak{0};
std::atomic<std::size_t> at_reset{0};

void* take(std::size_t bytes, std::size_t alignment) {
  void* const block = alignment > alignof(std::max_align_t)
                          ? std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment)
                          : std::malloc(bytes);
  if (block == nullptr) throw std::bad_alloc{};
  in_use += malloc_usable_size(block);
  if (in_use > peak) peak = in_use.load();
  return block;
}

void give_back(void* block) noexcept {
  if (block != nullptr) in_use -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t bytes) { return take(bytes, 0); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return take(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }

namespace floeplan::bench {

std::size_t peak_bytes() { return peak - at_reset; }
void reset_peak() {
  at_reset = in_use.load();
  peak = in_use.load();
}

}  // namespace floeplan::bench
