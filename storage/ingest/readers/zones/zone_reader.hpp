#pragma once

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Zones from the polygons of every layer: each feature one zone, or one for each part of a multipolygon, with what
/// `read_zone_attributes` reads. Projected coordinates are brought to WGS84.
/// Errors   every feature that cannot be used, a message each: a rule that silently went missing would be broken. A layer
///          without a reference system, unless the options state one
[[nodiscard]] Checked<PreparedDataset> read_zones(GDALDataset& dataset, const IngestOptions& options);

}  // namespace floeplan::ingest
