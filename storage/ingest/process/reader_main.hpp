#pragma once

#include <filesystem>
#include <vector>

namespace floeplan::ingest {

/// Name of the file in a staging folder that holds a ReaderRequest.
inline constexpr const char* reader_request_file = "request.json";

/// Name of the folder in the staging folder where an archive is unpacked.
inline constexpr const char* unpacked_folder = "unpacked";

/// The main function of a process that reads files from outside. It limits and confines itself before it
/// opens the first file, does what the request in `staging` says, and reports on standard output, one
/// ReaderEvent per line. The process must end afterwards. All names of folders and files are absolute.
/// Returns  the exit code: 0 unless the request could not be read
[[nodiscard]] int read_foreign_files(const std::filesystem::path& staging,
                                     const std::vector<std::filesystem::path>& files);

}  // namespace floeplan::ingest
