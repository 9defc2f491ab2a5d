#pragma once

#include "storage/ingest/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Land from GeoJSON polygons and multipolygons.
/// Errors   any polygon that cannot be used refuses the file: land that silently went missing would be run
/// aground on
[[nodiscard]] Checked<PreparedDataset> read_geojson_coastline(GDALDataset& dataset);

}  // namespace floeplan::ingest
