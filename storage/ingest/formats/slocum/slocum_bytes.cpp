#include "storage/ingest/formats/slocum/slocum_bytes.hpp"

#include <lz4.h>

#include <algorithm>

#include "storage/ingest/files/first_bytes.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t length_bytes = 2;
constexpr std::size_t longest_block = 0xffff;
constexpr std::size_t most_of_block = 255 * longest_block;  // 255 is the highest ratio of LZ4

std::size_t length_at(std::string_view packed, std::size_t at) {
  return (static_cast<std::size_t>(static_cast<unsigned char>(packed[at])) << 8) |
         static_cast<unsigned char>(packed[at + 1]);
}

SlocumBytes unpack_bytes(std::string_view packed, std::uintmax_t most) {
  SlocumBytes result;
  std::string room(most_of_block, '\0');
  for (std::size_t at = 0; at + length_bytes < packed.size() && result.bytes.size() < most;) {
    const std::size_t length = length_at(packed, at);
    at += length_bytes;
    if (length > packed.size() - at) break;
    const int size = LZ4_decompress_safe(packed.data() + at, room.data(), static_cast<int>(length),
                                         static_cast<int>(room.size()));
    if (size <= 0) {
      result.damaged = true;
      break;
    }
    result.bytes.append(room, 0,
                        std::min<std::uintmax_t>(static_cast<std::size_t>(size), most - result.bytes.size()));
    at += length;
  }
  return result;
}

}  // namespace

bool is_compressed_slocum(std::string_view head) {
  constexpr std::size_t longest_lead =
      8;  // the length of the block, and the length of its first uncompressed run
  const std::size_t lead = std::min(head.substr(0, 32).find("dbd_label:"), head.substr(0, 32).find("s: T"));
  return lead >= 3 && lead <= longest_lead;
}

SlocumBytes slocum_bytes(const std::filesystem::path& file, std::uintmax_t most) {
  std::string raw = first_bytes(file, most + length_bytes + longest_block);
  if (is_compressed_slocum(raw)) return unpack_bytes(raw, most);
  raw.resize(std::min<std::uintmax_t>(raw.size(), most));
  return {std::move(raw), false};
}

}  // namespace floeplan::ingest
