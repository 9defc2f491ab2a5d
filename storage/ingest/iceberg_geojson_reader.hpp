#pragma once

#include "storage/ingest/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Icebergs from GeoJSON points. Properties: `id` or `name`; `observed` or `time` (ISO 8601 with a zone);
/// optional `length_m`, `draft_m`, `size` (growler, bergy_bit, small, medium, large, very_large, unknown,
/// radar_target), `shape`, `method`. A bad feature is left out and counted.
[[nodiscard]] Checked<PreparedDataset> read_geojson_icebergs(GDALDataset& dataset);

}  // namespace floeplan::ingest
