#pragma once

#include <memory>

#include "engine/core/progress.hpp"
#include "storage/ingest/netcdf_file.hpp"
#include "storage/ingest/prepared_dataset.hpp"

namespace floeplan::ingest {

/// Currents from a NetCDF file on a regular longitude-latitude grid. Reads the file once to check every value
/// and a second time to write it, slice by slice, so memory holds one time and depth whatever the file's
/// size.
/// Errors   see the refusals of find_velocity_pair and layout_of; no time; nothing but missing values; faster
///          than 10 m/s
[[nodiscard]] Checked<PreparedDataset> read_currents(const std::shared_ptr<const NetcdfFile>& file,
                                                     const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
