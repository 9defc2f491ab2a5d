#pragma once

#include <filesystem>
#include <string>

#include "storage/ingest/refusal.hpp"

namespace floeplan::ingest {

/// SHA-256 of the file's bytes, lower-case hexadecimal; reads in blocks, so the file's size does not matter.
[[nodiscard]] Checked<std::string> sha256_of_file(const std::filesystem::path& file);

}  // namespace floeplan::ingest
