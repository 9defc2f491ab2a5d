#pragma once

#include <filesystem>
#include <string>

namespace floeplan::ingest {

/// The path under which GDAL sees a Zarr store of version 3, a folder, as one of version 2. GDAL 3.6 takes version 3
/// for an empty group. Nothing is written or copied: descriptions are translated when they are asked for, and the files
/// of chunks are those of the folder under the names that version 2 gives them.
/// Threads  any
[[nodiscard]] std::string zarr3_view(const std::filesystem::path& folder);

}  // namespace floeplan::ingest
