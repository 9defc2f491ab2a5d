#pragma once

#include <filesystem>
#include <string>

namespace floeplan::cli {

/// Writes a file, all or nothing: a reader never sees half of it. An existing one is replaced.
/// Errors   std::runtime_error when it cannot be written
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace floeplan::cli
