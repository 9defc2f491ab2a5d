#pragma once

#include <cstdint>
#include <filesystem>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Length in bytes that the header of a classic NetCDF file (CDF-1, CDF-2, CDF-5) says the file must have.
/// Libraries do not check it: they read zeros or fail late where the end of the file is missing.
/// Edges    the padding after the last value may be absent and is not counted
/// Errors   the header itself is damaged or cut short
/// Source   NetCDF Classic Format Specification, Unidata 2020, sections "header" and "Note on vsize"
[[nodiscard]] Checked<std::uint64_t> netcdf3_length(const std::filesystem::path& file);

}  // namespace floeplan::ingest
