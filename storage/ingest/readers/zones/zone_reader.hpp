#pragma once

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Zones from the polygons of all layers. A feature gives one zone, or one for each part of a multipolygon,
/// with the attributes from `read_zone_attributes`. Projected coordinates are transformed to WGS84.
/// Errors   a feature that cannot be used (each is reported), because a zone that is missing unnoticed would
///          be violated; a layer without a reference system, unless the options state one
[[nodiscard]] Checked<PreparedDataset> read_zones(GDALDataset& dataset, const IngestOptions& options);

}  // namespace floeplan::ingest
