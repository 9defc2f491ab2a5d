#include "storage/ingest/formats/hdf5/hdf5_heaps.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "storage/ingest/files/first_bytes.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t looked_at = 64U << 20U;
constexpr std::string_view heap_signature{"GCOL\x01\0\0\0", 8};  // with its version, and zeros
constexpr std::size_t heap_header_bytes = 16;                    // of a heap, and of an object in it

/// A little-endian number; where lengths have eight bytes, as every library writes them today.
template <class Number>
Number heap_number(std::string_view bytes, std::size_t at) {
  Number number{};
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// Objects one after the other, padded to eight bytes; number 0 is the room that is left.
bool objects_fit(std::string_view heap) {
  std::size_t at = heap_header_bytes;
  while (at + heap_header_bytes <= heap.size()) {
    const auto object = heap_number<std::uint16_t>(heap, at);
    const auto size = heap_number<std::uint64_t>(heap, at + 8);
    if (object == 0) return size <= heap.size() - at;
    if (size > heap.size() - at - heap_header_bytes) return false;
    at += heap_header_bytes + static_cast<std::size_t>((size + 7) / 8 * 8);
  }
  return true;
}

}  // namespace

bool hdf5_heaps_are_whole(const std::filesystem::path& file) {
  const std::string bytes = first_bytes(file, looked_at);
  const std::string_view all{bytes};
  for (std::size_t at = all.find(heap_signature); at != std::string_view::npos;
       at = all.find(heap_signature, at + 1)) {
    if (at + heap_header_bytes > all.size()) return true;
    const auto size = heap_number<std::uint64_t>(all, at + 8);
    const bool goes_on = all.size() == looked_at && size > all.size() - at;  // beyond what is looked at
    if (goes_on) return true;
    if (size > all.size() - at || !objects_fit(all.substr(at, static_cast<std::size_t>(size)))) return false;
  }
  return true;
}

}  // namespace floeplan::ingest
