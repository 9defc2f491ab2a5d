#pragma once

#include <cstddef>
#include <filesystem>

#include "storage/ingest/refusal.hpp"

namespace floeplan::ingest {

/// How many records a file of ISO/IEC 8211 has, the one that describes it included, by the length that each states of
/// itself. GDAL reads a file that was cut short as far as it goes.
/// Errors   a length that is no number or runs beyond the end of the file
/// Source   ISO/IEC 8211:1994, 6.2: the first five octets of a leader
[[nodiscard]] Checked<std::size_t> iso8211_records(const std::filesystem::path& file);

}  // namespace floeplan::ingest
