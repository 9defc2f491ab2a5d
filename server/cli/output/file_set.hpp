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

/// The first of the files that is there already; nothing when none is.
[[nodiscard]] std::optional<std::filesystem::path> first_existing(const std::filesystem::path& folder,
                                                                  const std::vector<OutputFile>& files);

/// Writes a set of files, making folders as needed. Every file is written in full beside its place before the first
/// one is moved there, so a reader never sees half a file, and a disk that fills up leaves the old set as it was.
/// Returns  the files written
/// Errors   std::runtime_error that names the file; nothing of the new set is left then
std::vector<std::filesystem::path> write_set(const std::filesystem::path& folder,
                                             const std::vector<OutputFile>& files);

}  // namespace floeplan::cli
