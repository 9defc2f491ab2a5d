#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace floeplan::ingest {

/// Names and contents of the files in an archive.
using ArchiveMembers = std::vector<std::pair<std::string, std::string>>;

enum class Packing { zip, tar_gz, gzip, bzip2, xz, zstd };

/// Writes an archive with libarchive; for a single compressed file only the first member's content.
void write_archive(const std::filesystem::path& file, Packing packing, const ArchiveMembers& members);

/// Reads these files as members, with their names below `folder`.
[[nodiscard]] ArchiveMembers members_of(const std::vector<std::filesystem::path>& files,
                                        const std::string& folder = "");

}  // namespace floeplan::ingest
