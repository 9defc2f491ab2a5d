#pragma once

#include <filesystem>
#include <functional>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"

namespace floeplan::ingest {

/// Whether a NetCDF file is a Slocum log written by dbd2netcdf: a variable for each sensor along one
/// dimension, with m_present_time and positions.
[[nodiscard]] bool is_slocum_netcdf(const NetcdfFile& file);
[[nodiscard]] bool holds_slocum_netcdf(const std::filesystem::path& file);

/// Reads such a log, as `take_slocum_table` does.
/// Bounds   2 million rows
/// Errors   GDAL cannot read the file (its own words); those of `take_slocum_table`
/// Source   dbd2netcdf 1.7: units of sensors as in masterdata, NaN where a sensor was not updated
[[nodiscard]] Checked<SlocumLog> read_slocum_netcdf(const std::filesystem::path& file,
                                                    const std::function<void(const SlocumRow&)>& take);

}  // namespace floeplan::ingest
