#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "storage/ingest/refusal.hpp"
#include "storage/repository/dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Opens a GeoJSON file with one layer in longitude and latitude on WGS84 (RFC 7946).
/// Errors   damaged JSON; no features; another coordinate reference system (pre-RFC "crs" member)
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_geojson(const std::filesystem::path& file);

/// Points are icebergs, polygons are zones where one of them states the rule of a zone, or where zones are wanted, else
/// land.
/// Errors   other or mixed geometries
[[nodiscard]] Checked<repository::DatasetKind> kind_of_geojson(GDALDataset& dataset,
                                                               std::optional<repository::DatasetKind> wanted);

}  // namespace floeplan::ingest
