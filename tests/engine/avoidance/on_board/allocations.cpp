#include "tests/engine/avoidance/on_board/allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

/// A program replaces these operators as a whole, so they stand in a file of their own.
namespace {

std::atomic<std::size_t> taken{0};

void* take(std::size_t bytes, std::size_t alignment) {
  ++taken;
  void* const block = alignment > alignof(std::max_align_t)
                          ? std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment)
                          : std::malloc(bytes);
  if (block == nullptr) throw std::bad_alloc{};
  return block;
}

}  // namespace

void* operator new(std::size_t bytes) { return take(bytes, 0); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return take(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }

namespace floeplan::support {

std::size_t allocations() { return taken; }

}  // namespace floeplan::support
