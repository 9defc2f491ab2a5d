#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace floeplan::ingest {

/// Names and contents.
using ArchiveMembers = std::vector<std::pair<std::string, std::string>>;

enum class Packing { zip, tar_gz, gzip, bzip2, xz, zstd };

/// Writes an archive with libarchive; of one compressed file the first member's content alone.
void write_archive(const std::filesystem::path& file, Packing packing, const ArchiveMembers& members);

/// Members that are the files of these names.
[[nodiscard]] ArchiveMembers members_of(const std::vector<std::filesystem::path>& files,
                                        const std::string& folder = "");

}  // namespace floeplan::ingest
