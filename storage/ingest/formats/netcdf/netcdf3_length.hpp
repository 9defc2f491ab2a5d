#pragma once

#include <cstdint>
#include <filesystem>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// The least length in bytes of a classic NetCDF file (CDF-1, CDF-2, CDF-5), computed from its header.
/// Libraries do not check it: if the end of the file is missing, they read zeros or fail late.
/// Edges    the padding after the last value may be absent and is not counted
/// Errors   the header itself is damaged or cut short
/// Source   NetCDF Classic Format Specification, Unidata 2020, sections "header" and "Note on vsize"
[[nodiscard]] Checked<std::uint64_t> netcdf3_length(const std::filesystem::path& file);

}  // namespace floeplan::ingest
