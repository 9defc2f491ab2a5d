#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "storage/ingest/file_groups.hpp"
#include "storage/ingest/slocum_log.hpp"

namespace floeplan::ingest {

/// Whether the first bytes of a file are those of a Slocum's binary log (dbd, sbd, mbd and the like, not compressed).
[[nodiscard]] bool is_slocum_binary(std::string_view head);
[[nodiscard]] bool holds_slocum_binary(const std::filesystem::path& file);

/// Whether they are those of a log, or a list of sensors, in blocks compressed by LZ4, each after its length in two bytes:
/// the first block begins with the first tag as it is.
/// Source  dbdreader, decompress.py (github.com/smerckel/dbdreader)
[[nodiscard]] bool is_compressed_slocum(std::string_view head);

/// Whether they are those of a cache: the list of sensors that logs refer to by its checksum, "1f35be3b.cac".
[[nodiscard]] bool is_sensor_cache(std::string_view head);
[[nodiscard]] bool holds_sensor_cache(const std::filesystem::path& file);

/// Whether a cache, by its name, is the one that a log refers to.
[[nodiscard]] bool is_cache_of(const std::filesystem::path& cache, const std::filesystem::path& log);

/// What is left of the files of a group.
[[nodiscard]] FileGroup without_sensor_caches(const FileGroup& files);

/// Reads a binary log cycle by cycle. `take` gets the rows in the order of the file. The list of sensors of a factored log
/// is in its cache: among `given`, else beside the log.
/// Format   lines "key: value"; the list of sensors unless factored; 16 known bytes 's', 'a', 0x1234, 123.456,
///          123456789.12345, which tell the order of the bytes; cycles of a 'd', two bits for each sensor, the first one
///          highest (0: not updated, 1: as before, 2: new) and the new values of 1, 2, 4 or 8 bytes; an 'X'
/// Edges    a log that ends before its 'X' gives what is whole, and says so
/// Bounds   200 MB
/// Source   Teledyne Webb Research, Slocum glider masterdata and binary data file format; values compared with those of
///          the same log as text
/// Errors   a sensor in another unit than masterdata's; a cache that is not there or does not fit; bytes that are no cycle
[[nodiscard]] Checked<SlocumLog> read_slocum_binary(const std::filesystem::path& file, const FileGroup& given,
                                                    const std::function<void(const SlocumRow&)>& take);

}  // namespace floeplan::ingest
