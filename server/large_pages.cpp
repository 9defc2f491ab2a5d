#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

/// An array of this size fills at least one page of 2 MiB, wherever it begins.
constexpr std::size_t least_bytes = std::size_t{4} << 20;

/// Lets the kernel put an array on pages of 2 MiB: one page fault instead of 512. Most systems do so only if
/// asked ("madvise" in /sys/kernel/mm/transparent_hugepage/enabled). If it refuses, nothing is lost.
void ask_for_large_pages(void* begin, std::size_t bytes) {
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / page * page;
  (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace

// The program's own allocation, for all arrays of currents, depths and ice. A seventh part of a plan's time went
// into page faults.

void* operator new(std::size_t bytes) {
  while (true) {
    if (void* const memory = std::malloc(bytes == 0 ? 1 : bytes)) {
      if (bytes >= least_bytes) ask_for_large_pages(memory, bytes);
      return memory;
    }
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc{};
    handler();
  }
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
