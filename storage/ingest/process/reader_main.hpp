#pragma once

#include <filesystem>
#include <vector>

namespace floeplan::ingest {

/// Name of the file in a staging folder that holds a ReaderRequest.
inline constexpr const char* reader_request_file = "request.json";

/// Name of the folder in the staging folder where an archive is unpacked.
inline constexpr const char* unpacked_folder = "unpacked";

/// The whole of a process that reads foreign files: bounds and confines itself before it opens the first of them, does
/// what the request in `staging` says, and tells it on standard output, one ReaderEvent a line. Nothing else of the
/// process is of use afterwards. Both folders' and files' names are absolute.
/// Returns  its exit code: 0 unless the request could not be read
[[nodiscard]] int read_foreign_files(const std::filesystem::path& staging,
                                     const std::vector<std::filesystem::path>& files);

}  // namespace floeplan::ingest
