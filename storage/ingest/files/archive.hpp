#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether a file is an archive (zip, also KMZ; tar) or a single compressed file (gzip, bzip2, xz, zstd,
/// compress). The first bytes decide.
[[nodiscard]] bool is_archive(const std::filesystem::path& file);

/// The content of an archive.
struct Unpacked {
  std::vector<std::filesystem::path>
      data;                           // files that are to be read, and folders that are Zarr stores; sorted
  std::vector<std::string> left_out;  // names of documents and pictures among the data
};

/// Unpacks an archive into `folder`, under the names in the archive. A single compressed file gets its own
/// name without the ending. Checksums are compared where the format has them.
/// `is_data`  is called for files with the ending of a document, and says whether such a file holds data all
///            the same
/// Errors     the archive is damaged, cut short or has a password; a name leads out of the folder or occurs
///            twice; an entry is a link; there are more than 100,000 entries or more than
///            `most_unpacked_bytes`. Then nothing is read
[[nodiscard]] Checked<Unpacked> unpack(const std::filesystem::path& archive,
                                       const std::filesystem::path& folder,
                                       const std::function<bool(const std::filesystem::path&)>& is_data);

/// Limit on the unpacked size of an archive. Ice charts, depths and model output shrink to a third or a
/// tenth. A file that shrinks a thousandfold was made to fill disks.
[[nodiscard]] std::uint64_t most_unpacked_bytes(std::uint64_t packed_bytes);

}  // namespace floeplan::ingest
