#pragma once

#include <memory>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The variable that holds depths or elevations; null when none claims to. With `any_plane` a lone variable
/// over two dimensions is taken whatever its name.
[[nodiscard]] const NetcdfVariable* find_bathymetry(const NetcdfFile& file, bool any_plane);

/// Bathymetry from the coordinate variables of a NetCDF file (never from a mean grid step, which real axes do
/// not keep).
[[nodiscard]] Checked<PreparedDataset> read_netcdf_bathymetry(std::shared_ptr<const NetcdfFile> file,
                                                              const IngestOptions& options);

}  // namespace floeplan::ingest
