#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floeplan::cli {

/// A file to be written below a folder.
struct OutputFile {
  std::filesystem::path name;  // relative
  std::string bytes;
};

/// The first of the files that exists already; nullopt if none does.
[[nodiscard]] std::optional<std::filesystem::path> first_existing(const std::filesystem::path& folder,
                                                                  const std::vector<OutputFile>& files);

/// Writes a set of files; folders are created as needed. All files are first written completely under
/// temporary names and then renamed, so that a reader never sees half a file, and a full disk leaves the old
/// files unchanged.
/// Returns  the files written
/// Errors   std::runtime_error that names the file; no new file is left
std::vector<std::filesystem::path> write_set(const std::filesystem::path& folder,
                                             const std::vector<OutputFile>& files);

}  // namespace floeplan::cli
