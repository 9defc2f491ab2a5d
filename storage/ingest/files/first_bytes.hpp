#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace floeplan::ingest {

/// At most `most` bytes from the beginning of a file; fewer if the file is shorter, none if it cannot be
/// read.
[[nodiscard]] std::string first_bytes(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace floeplan::ingest
