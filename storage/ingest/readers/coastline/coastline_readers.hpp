#pragma once

#include <filesystem>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Land from the polygons of all layers, transformed to WGS84. Ice shelves count as land, because nothing
/// passes below them.
/// Errors   a polygon that cannot be used: the file is refused, because a route could run aground on land
///          that is missing; a layer without a reference system, unless the options state one
[[nodiscard]] Checked<PreparedDataset> read_coastline(GDALDataset& dataset, const IngestOptions& options);

/// The land of the whole globe from a GSHHG shoreline in the binned format of GMT (see is_gshhg), as one coastline
/// dataset. Reads the file once to check it and a second time to write it, in bands of latitude, so memory
/// holds one band. Measured full resolution: 216 thousand polygons, 10.5 million corners, 15 s, 92 MB in the
/// store
/// Errors   a file that contradicts itself
[[nodiscard]] Checked<PreparedDataset> read_gshhg_coastline(const std::filesystem::path& file,
                                                            const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
