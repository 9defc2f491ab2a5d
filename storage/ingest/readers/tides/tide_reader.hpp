#pragma once

#include <filesystem>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Harmonic constants of a tide model on a grid, elevations and currents, in the first of the files. Transports are
/// divided by the depth of the water column, there or in another of the files; components between the nodes (C-grid)
/// are brought to the nodes of the elevations.
/// Errors   see the refusals of find_tides, tide_layout_of and tide_names; a constituent that this program does not
///          know; transports without depths; elevations over 20 m or currents over 10 m/s; nothing but missing values
[[nodiscard]] Checked<PreparedDataset> read_tides(const NetcdfFiles& files, const std::filesystem::path& path,
                                                  const IngestOptions& options,
                                                  const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
