#pragma once

#include <memory>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Concentration of sea ice, and its thickness where the file has one, on a regular grid in longitude and latitude
/// or on a projected one. Of several estimates the greatest at each place counts, because more ice is the safer
/// answer; a place is missing where all of them are. A draft of level ice becomes a thickness by floating.
/// Errors   no time, neither in the file nor in the options; a unit that is wrong or unclear; nothing but missing
///          values; grids that are not read
[[nodiscard]] Checked<PreparedDataset> read_ice(const std::shared_ptr<const NetcdfFile>& file,
                                                const IngestOptions& options,
                                                const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
