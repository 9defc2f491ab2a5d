#pragma once

#include <filesystem>
#include <string>

namespace floeplan::ingest {

/// The path under which GDAL sees a folder with a Zarr store of version 3 as a store of version 2. GDAL 3.6
/// itself takes version 3 for an empty group. Nothing is written or copied: descriptions are translated when
/// GDAL reads them, and chunk files are opened under their names of version 2.
/// Threads  any
[[nodiscard]] std::string zarr3_view(const std::filesystem::path& folder);

}  // namespace floeplan::ingest
