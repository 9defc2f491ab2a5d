#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace floeplan::ingest {

/// Whether a file begins like a compressed Slocum log or sensor list (dcd, scd, ... and ccc): the first block
/// starts with the first tag, uncompressed.
[[nodiscard]] bool is_compressed_slocum(std::string_view head);

/// The content of a Slocum file, unpacked if it was compressed.
struct SlocumBytes {
  std::string bytes;
  bool damaged{false};  // a block could not be unpacked; this block and all later ones are missing
};

/// At most `most` bytes from the beginning of the content.
/// Format   a compressed file consists of blocks: the length in two bytes, the higher one first, then as many
///          bytes in LZ4's block format. An incomplete last block is ignored
/// Source   dbdreader, decompress.py (github.com/smerckel/dbdreader)
[[nodiscard]] SlocumBytes slocum_bytes(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace floeplan::ingest
