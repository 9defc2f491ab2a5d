#pragma once

#include <filesystem>
#include <memory>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Opens a GeoJSON file with one layer in longitude and latitude on WGS84 (RFC 7946).
/// Errors   damaged JSON; no features; another coordinate reference system (pre-RFC "crs" member)
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_geojson(const std::filesystem::path& file);

}  // namespace floeplan::ingest
