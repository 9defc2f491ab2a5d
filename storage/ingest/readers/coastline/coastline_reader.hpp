#pragma once

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Land from the polygons of every layer, brought to WGS84. Ice shelves count as land: nothing passes below them.
/// Errors   any polygon that cannot be used refuses the file: land that silently went missing would be run
///          aground on. A layer without a reference system, unless the options state one
[[nodiscard]] Checked<PreparedDataset> read_coastline(GDALDataset& dataset, const IngestOptions& options);

}  // namespace floeplan::ingest
