#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "storage/ingest/file_format.hpp"

namespace floeplan::ingest {

/// What to tell of a table of text whose last line has no end: it may be whole, or cut within its last number, which
/// then is another number and no fault. Nothing of formats that know their length, and of lines that end.
[[nodiscard]] std::optional<std::string> warning_of_open_end(const std::filesystem::path& file,
                                                             FileFormat format);

}  // namespace floeplan::ingest
