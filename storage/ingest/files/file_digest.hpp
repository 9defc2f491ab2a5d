#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// SHA-256 of the file's bytes, lower-case hexadecimal; reads in blocks, so the file's size does not matter.
[[nodiscard]] Checked<std::string> sha256_of_file(const std::filesystem::path& file);
/// SHA-256 of a text, lower-case hexadecimal.
[[nodiscard]] std::string sha256_of_text(const std::string& text);

/// SHA-256 of one file. For several files: SHA-256 of their digests in order.
[[nodiscard]] Checked<std::string> sha256_of_files(const std::vector<std::filesystem::path>& files);

}  // namespace floeplan::ingest
