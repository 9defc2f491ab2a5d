#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace floeplan::ingest {

/// Whether the first bytes of a file are those of a binary log of a Slocum, or of a list of sensors, in compressed
/// blocks (dcd, scd, ... and ccc): the first block begins with the first tag as it is.
[[nodiscard]] bool is_compressed_slocum(std::string_view head);

/// What stands in a file of a Slocum, unpacked where it is compressed.
struct SlocumBytes {
  std::string bytes;
  bool damaged{false};  // a block cannot be unpacked: it and what follows it are left out
};

/// At most `most` bytes from the beginning.
/// Format   of a compressed file: blocks, each its length in two bytes, the higher one first, and as many bytes of
///          LZ4's block format. A last block that is not whole is left out
/// Source   dbdreader, decompress.py (github.com/smerckel/dbdreader)
[[nodiscard]] SlocumBytes slocum_bytes(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace floeplan::ingest
