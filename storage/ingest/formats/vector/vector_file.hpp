#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Whether a file is a GeoPackage, by the application's id in the head of an SQLite database, "GPKG" or, of version 1.1
/// and before, "GP10", "GP11".
/// Source  OGC 12-128, requirement 2; sqlite.org/fileformat.html, 1.3
[[nodiscard]] bool is_geopackage(std::string_view head);

/// Opens a file of features with one of GDAL's drivers, "GPKG" or "ESRI Shapefile".
/// Errors   damaged; a GeoPackage with views, computed columns or virtual tables but R*Trees; no features; a value that GDAL leaves out since it is none of its column's type
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_vector_file(const std::filesystem::path& file,
                                                                     const char* driver);

/// A shapefile and the files beside it that belong to it.
[[nodiscard]] std::vector<std::filesystem::path> parts_of_shapefile(const std::filesystem::path& file);

}  // namespace floeplan::ingest
