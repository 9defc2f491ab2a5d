#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether a file is an archive (zip, and so KMZ; tar) or one compressed file (gzip, bzip2, xz, zstd, compress), told
/// by its first bytes.
[[nodiscard]] bool is_archive(const std::filesystem::path& file);

/// What came out of an archive.
struct Unpacked {
  std::vector<std::filesystem::path>
      data;  // files that are worth reading, and folders that are Zarr stores, sorted
  std::vector<std::string> left_out;  // names of documents and pictures that lay beside the data
};

/// Lays out in `folder` what an archive holds, under the names that it has there; of one compressed file, under its own
/// name without the ending. Checksums are compared where the format has them.
/// `is_data`  asked of files that are called as documents are: whether one holds data all the same
/// Errors   damaged or cut short; protected by a password; a name that leads out of the folder, twice the same one, a
///          link; more files than any product has, or more bytes than `most_unpacked_bytes`: nothing is read then
[[nodiscard]] Checked<Unpacked> unpack(const std::filesystem::path& archive,
                                       const std::filesystem::path& folder,
                                       const std::function<bool(const std::filesystem::path&)>& is_data);

/// How much an archive may unpack to. Ice charts, depths and model output shrink to a third or a tenth; what shrinks a
/// thousandfold is made to fill disks.
[[nodiscard]] std::uint64_t most_unpacked_bytes(std::uint64_t packed_bytes);

}  // namespace floeplan::ingest
