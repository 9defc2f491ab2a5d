#pragma once

#include <filesystem>
#include <functional>

#include "storage/ingest/files/file_group.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"

namespace floeplan::ingest {

/// Reads a binary log cycle by cycle. `take` gets the rows in the order of the file.
/// Format   the header; 16 known bytes: 's', 'a', 0x1234, 123.456, 123456789.12345, which show the byte
///          order; then cycles: a 'd', two bits for each sensor, the first sensor highest (0: not updated, 1:
///          same value, 2: new value), and the new values of 1, 2, 4 or 8 bytes each; at the end an 'X'
/// Edges    a log without its 'X' gives its complete cycles and is marked as cut short
/// Bounds   200 MB
/// Source   Teledyne Webb Research, Slocum glider masterdata and binary data file format; values compared with those of
///          the same log as text
/// Errors   a sensor in another unit than in masterdata; the sensor cache is missing or does not match;
///          damaged cycles
[[nodiscard]] Checked<SlocumLog> read_slocum_binary(const std::filesystem::path& file, const FileGroup& given,
                                                    const std::function<void(const SlocumRow&)>& take);

}  // namespace floeplan::ingest
