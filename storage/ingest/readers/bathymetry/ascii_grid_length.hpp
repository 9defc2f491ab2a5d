#pragma once

#include <cstdint>
#include <filesystem>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Checks that an ESRI ASCII grid holds as many values as its header announces. Needed because GDAL 3.6 waits
/// for ever for the values of a file that was cut short.
/// Returns  the number of values
/// Errors   no usable ncols and nrows; too few values
[[nodiscard]] Checked<std::uint64_t> ascii_grid_length(const std::filesystem::path& file);

}  // namespace floeplan::ingest
